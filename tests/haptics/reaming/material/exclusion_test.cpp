#include <cmath>
#include <map>

#include <gtest/gtest.h>

#include "haptics/reaming/material/series.h"
#include "haptics/reaming/material/synthetic_series.h"
#include "tests/support/long_form.h"

namespace haptics::reaming {
namespace exclusion_test {

TEST(Exclusion, FindsThePapersTenOfSeventyTwoAndNoOther) {
  const auto studies = static_cast<std::uint64_t>(tests::inLongForm(3, 1));
  for (std::uint64_t seed = 1; seed <= studies; ++seed) {
    std::map<ExclusionReason, int> found;
    const auto study = syntheticStudy(seed);
    ASSERT_EQ(study.size(), 72U);
    for (const auto& series : study) {
      const auto exclusion = exclusionOf(series);
      ++found[exclusion.reason];
      EXPECT_EQ(exclusion.isExcluded(), !exclusion.words.empty());
    }
    EXPECT_EQ(found[ExclusionReason::None], 62) << seed;
    EXPECT_EQ(found[ExclusionReason::FeedChanged], 2) << seed;
    EXPECT_EQ(found[ExclusionReason::BrokeOut], 4) << seed;
    EXPECT_EQ(found[ExclusionReason::ReamedThrough], 4) << seed;
  }
}

TEST(Exclusion, GivesAReasonForInvalidData) {
  const auto sound = syntheticSeries({});
  const auto wordsOf = [](const Series& series) {
    const auto exclusion = exclusionOf(series);
    EXPECT_EQ(exclusion.reason, ExclusionReason::Implausible);
    return exclusion.words;
  };
  auto nan = sound;
  nan.force[4711] = std::nan("");
  EXPECT_EQ(wordsOf(nan), "sample 4712 is no number");
  auto reversed = sound;
  for (double& x : reversed.displacement) x = -x;
  EXPECT_NE(wordsOf(reversed).find("the axis is reversed"), std::string::npos);
  auto lopsided = sound;
  lopsided.torque.pop_back();
  EXPECT_NE(wordsOf(lopsided).find("differ in length"), std::string::npos);
  auto brief = sound;
  brief.displacement.resize(2);
  brief.force.resize(2);
  brief.torque.resize(2);
  EXPECT_NE(wordsOf(brief).find("it has 2 samples"), std::string::npos);
  EXPECT_FALSE(exclusionOf(sound).isExcluded());
}

TEST(SyntheticSeries, HaveThePublishedProperties) {
  for (const auto& series : syntheticStudy(5)) {
    EXPECT_TRUE(series.isSynthetic);
    EXPECT_EQ(series.rate, 100.0);
    EXPECT_LE(series.displacement.back(), 0.02);
    if (series.set != TestSet::Static) {
      EXPECT_EQ(series.torque.size(), series.force.size());
      continue;
    }
    EXPECT_TRUE(series.torque.empty());
    EXPECT_NEAR(series.force.front(), 20.0, 5.0);  // the preload
    EXPECT_LT(series.force.back(), 810.0);
    const double feed =
        (series.displacement[100] - series.displacement[0]) * 1000.0;  // over a second
    EXPECT_NEAR(feed, 0.07, 1e-9);
  }
}

TEST(SyntheticSeries, AreTheSameEveryTime) {
  EXPECT_EQ(syntheticSeries({.seed = 9}).force, syntheticSeries({.seed = 9}).force);
  EXPECT_NE(syntheticSeries({.seed = 9}).force, syntheticSeries({.seed = 8}).force);
}

}  // namespace exclusion_test
}  // namespace haptics::reaming
