#include "haptics/reaming/material/envelope.h"

#include <gtest/gtest.h>

namespace haptics::reaming {
namespace envelope_test {

constexpr double kStep = 0.1e-3;  // [m]

/// Values at 0, 0.1, 0.2 mm, …
SpecimenCurve specimen(const std::vector<double>& y, bool isCensored = false) {
  SpecimenCurve result{.last = y.back(), .isCensored = isCensored};
  for (std::size_t i = 0; i < y.size(); ++i) {
    result.curve.x.push_back(kStep * static_cast<double>(i));
  }
  result.curve.y = y;
  result.end = result.curve.x.back();
  return result;
}

/// From @p from on, with the same rise each step.
std::vector<double> line(double from, double rise, std::size_t count) {
  std::vector<double> y;
  for (std::size_t i = 0; i < count; ++i) y.push_back(from + rise * static_cast<double>(i));
  return y;
}

void expectOrdered(const Envelope& envelope) {
  for (std::size_t i = 0; i < envelope.average.size(); ++i) {
    EXPECT_LE(envelope.minimum.y[i], envelope.average.y[i]) << i;
    EXPECT_LE(envelope.average.y[i], envelope.maximum.y[i]) << i;
  }
}

void expectNeverFalls(const SampledCurve& curve) {
  for (std::size_t i = 1; i < curve.size(); ++i) EXPECT_GE(curve.y[i], curve.y[i - 1] - 1e-12) << i;
}

TEST(Envelope, HasTheSoftestTheMiddleAndTheHardestOfItsSpecimens) {
  const std::vector specimens{
      specimen({20.0, 30.0, 41.0}), specimen({2.0, 3.0, 4.0}), specimen({5.0, 6.0, 7.0})};
  const auto envelope = depthEnvelopeOf(specimens, EnvelopeRule::SingleSample).curves;
  EXPECT_EQ(envelope.minimum.y, specimens[1].curve.y);
  EXPECT_EQ(envelope.average.y, specimens[2].curve.y);
  EXPECT_EQ(envelope.maximum.y, specimens[0].curve.y);
}

TEST(Envelope, RanksSpecimensByTheDepthsThatAllOfThemHave) {
  // The soft one goes on to 90; the hard one ended at 50.
  const std::vector specimens{specimen({40.0, 50.0}), specimen({10.0, 20.0, 60.0, 90.0})};
  const auto envelope = depthEnvelopeOf(specimens, EnvelopeRule::SingleSample).curves;
  EXPECT_EQ(envelope.minimum.y, specimens[1].curve.y);
  EXPECT_EQ(envelope.maximum.y, (std::vector<double>{40.0, 50.0, 50.0, 50.0}));
}

TEST(Envelope, HasTheSmallestTheMeanAndTheLargestForceAtEachPlace) {
  const std::vector crossing{
      specimen({9.0, 1.0, 5.0}), specimen({1.0, 9.0, 6.0}), specimen({2.0, 2.0, 10.0})};
  for (const auto& envelope :
       {depthEnvelopeOf(crossing, EnvelopeRule::Pointwise).curves,
        envelopeOfRunningTests(crossing, EnvelopeRule::Pointwise).curves}) {
    EXPECT_EQ(envelope.minimum.y, (std::vector<double>{1.0, 1.0, 5.0}));
    EXPECT_EQ(envelope.average.y, (std::vector<double>{4.0, 4.0, 7.0}));
    EXPECT_EQ(envelope.maximum.y, (std::vector<double>{9.0, 9.0, 10.0}));
    expectOrdered(envelope);
  }
}

TEST(Envelope, OfOneSpecimenIsThatSpecimen) {
  const std::vector one{specimen({3.0, 1.0, 2.0})};
  for (const auto rule : {EnvelopeRule::Pointwise, EnvelopeRule::SingleSample}) {
    const auto envelope = depthEnvelopeOf(one, rule).curves;
    for (const auto* part : {&envelope.minimum, &envelope.average, &envelope.maximum}) {
      EXPECT_EQ(part->y, one[0].curve.y);
    }
  }
}

TEST(Envelope, HoldsASpecimenThatEndedAtItsForceLimit) {
  const std::vector specimens{specimen({400.0, 800.0}, true), specimen(line(100.0, 10.0, 30))};
  const auto envelope = depthEnvelopeOf(specimens, EnvelopeRule::Pointwise);
  for (std::size_t i = 2; i < 30; ++i) {
    EXPECT_EQ(envelope.curves.maximum.y[i], 800.0);
    EXPECT_DOUBLE_EQ(envelope.curves.average.y[i], 0.5 * (800.0 + specimens[1].curve.y[i]));
    EXPECT_EQ(envelope.measured[i], 1);
    EXPECT_EQ(envelope.held[i], 1);
  }
}

TEST(Envelope, BlendsOutASpecimenThatStalled) {
  // The soft one leaves at 1 mm with 20 N; halfway, at 1.25 mm, it counts for a half.
  const std::vector specimens{specimen(line(10.0, 1.0, 11)), specimen(line(80.0, 0.0, 31))};
  const auto envelope = depthEnvelopeOf(specimens, EnvelopeRule::Pointwise);
  const auto& curves = envelope.curves;
  EXPECT_DOUBLE_EQ(curves.minimum.y[10], 20.0);
  EXPECT_NEAR(curves.minimum.y[12], 0.6 * 20.0 + 0.4 * 80.0, 1e-9);
  EXPECT_NEAR(curves.average.y[12], (0.6 * 20.0 + 80.0) / 1.6, 1e-9);
  EXPECT_NEAR(curves.minimum.y[15], 80.0, 1e-9);
  EXPECT_EQ(envelope.measured[10], 2);
  EXPECT_EQ(envelope.measured[11], 1);
  EXPECT_EQ(envelope.held[11], 0);
}

TEST(Envelope, NeverFallsBecauseASpecimenEnds) {
  // The hardest leaves at 1 mm; what is left rises, but to 1.6 mm not above it.
  const std::vector specimens{
      specimen(line(50.0, 5.0, 11)), specimen(line(20.0, 3.0, 41)), specimen(line(10.0, 2.0, 41))};
  const auto curves = depthEnvelopeOf(specimens, EnvelopeRule::Pointwise).curves;
  for (const auto* curve : {&curves.minimum, &curves.average, &curves.maximum}) {
    expectNeverFalls(*curve);
  }
  expectOrdered(curves);
  EXPECT_NEAR(curves.maximum.y[20], 100.0, 1e-9);
  EXPECT_NEAR(curves.maximum.y[40], 20.0 + 3.0 * 40.0, 1e-9);  // caught up at 2.7 mm
  EXPECT_NEAR(curves.average.y[40], 0.5 * (140.0 + 90.0), 1e-9);
}

TEST(Envelope, FallsWithTheRemainingSpecimens) {
  auto softening = line(60.0, 0.0, 21);
  for (std::size_t i = 0; i < 20; ++i) softening.push_back(60.0 - 2.0 * static_cast<double>(i + 1));
  const std::vector specimens{specimen(line(100.0, 0.0, 11)), specimen(softening)};
  const auto& maximum = depthEnvelopeOf(specimens, EnvelopeRule::Pointwise).curves.maximum;
  EXPECT_NEAR(maximum.y[20], 100.0, 1e-9);
  EXPECT_NEAR(maximum.y[40], 60.0, 1e-9);
}

TEST(Envelope, OfPresentSpecimensHasAStepWhereATestEnds) {
  const std::vector specimens{specimen({5.0, 9.0}), specimen({1.0, 2.0, 3.0})};
  const auto envelope = envelopeOfRunningTests(specimens, EnvelopeRule::Pointwise);
  EXPECT_EQ(envelope.curves.maximum.y, (std::vector<double>{5.0, 9.0, 3.0}));
  EXPECT_EQ(envelope.measured, (std::vector<int>{2, 2, 1}));
}

}  // namespace envelope_test
}  // namespace haptics::reaming
