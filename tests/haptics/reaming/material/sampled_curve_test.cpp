#include "haptics/reaming/material/sampled_curve.h"

#include <gtest/gtest.h>

namespace haptics::reaming {
namespace sampled_curve_test {

SampledCurve curve(const std::vector<double>& y) {
  return {.x = {0.0, 0.5, 1.0}, .y = y};
}

void expectOrdered(const Envelope& envelope) {
  for (std::size_t i = 0; i < envelope.average.size(); ++i) {
    EXPECT_LE(envelope.minimum.y[i], envelope.average.y[i]) << i;
    EXPECT_LE(envelope.average.y[i], envelope.maximum.y[i]) << i;
  }
}

TEST(Envelope, HasTheSoftestTheMiddleAndTheHardestOfItsSamples) {
  const std::vector<SampledCurve> curves{
      curve({20.0, 30.0, 41.0}), curve({2.0, 3.0, 4.0}), curve({5.0, 6.0, 7.0})};
  const auto envelope = envelopeOf(curves, EnvelopeRule::SingleSample);
  EXPECT_EQ(envelope.minimum.y, curves[1].y);
  EXPECT_EQ(envelope.average.y, curves[2].y);
  EXPECT_EQ(envelope.maximum.y, curves[0].y);
  expectOrdered(envelope);
}

TEST(Envelope, HasTheSmallestTheMeanAndTheLargestForceAtEachPlace) {
  const std::vector<SampledCurve> crossing{
      curve({9.0, 1.0, 5.0}), curve({1.0, 9.0, 6.0}), curve({2.0, 2.0, 10.0})};
  const auto envelope = envelopeOf(crossing, EnvelopeRule::Pointwise);
  EXPECT_EQ(envelope.minimum.y, (std::vector<double>{1.0, 1.0, 5.0}));
  EXPECT_EQ(envelope.average.y, (std::vector<double>{4.0, 4.0, 7.0}));
  EXPECT_EQ(envelope.maximum.y, (std::vector<double>{9.0, 9.0, 10.0}));
  expectOrdered(envelope);
}

TEST(Envelope, OfOneSampleIsThatSample) {
  const std::vector<SampledCurve> one{curve({3.0, 1.0, 2.0})};
  for (const auto rule : {EnvelopeRule::Pointwise, EnvelopeRule::SingleSample}) {
    const auto envelope = envelopeOf(one, rule);
    for (const auto* part : {&envelope.minimum, &envelope.average, &envelope.maximum}) {
      EXPECT_EQ(part->y, one[0].y);
    }
  }
}

}  // namespace sampled_curve_test
}  // namespace haptics::reaming
