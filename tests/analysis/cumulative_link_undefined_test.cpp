#include <cmath>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "analysis/models/cumulative_link_mixed_model.h"

namespace cumulative_link_undefined_test {

using analysis::Factor;
using analysis::FixedEffects;

const std::vector<std::string> kMethod{"a", "a", "a", "b", "b", "b", "a", "a", "a", "b", "b", "b"};
const std::vector<std::string> kPerson{"1", "1", "1", "1", "1", "1", "2", "2", "2", "2", "2", "2"};

FixedEffects methods() {
  FixedEffects fixed(kMethod.size());
  fixed.add(analysis::factorOf("method", kMethod));
  return fixed;
}

analysis::Reason reasonOf(const std::vector<int>& y, const std::vector<Factor>& random = {}) {
  const auto result = analysis::fitCumulativeLinkMixedModel(y, methods(), random);
  EXPECT_FALSE(result.fit.has_value());
  return result.reason;
}

TEST(CumulativeLinkUndefined, ForAnswersThatAreAllTheSame) {
  const auto why = reasonOf(std::vector<int>(12, 4));
  EXPECT_EQ(why, analysis::reason("all_answers_same"));
}

TEST(CumulativeLinkUndefined, ForAMethodWhoseAnswersAreAllTheHighest) {
  const auto why = reasonOf({1, 2, 3, 5, 5, 5, 2, 3, 5, 5, 5, 5});
  EXPECT_EQ(why, analysis::reason("all_highest", "b", "method", 5));
}

TEST(CumulativeLinkUndefined, ForMethodsThatShareNoAnswer) {
  const auto why = reasonOf({1, 2, 1, 4, 5, 4, 2, 1, 2, 5, 4, 5});
  EXPECT_EQ(why, analysis::reason("separated"));
}

TEST(CumulativeLinkUndefined, ForOneParticipant) {
  const auto alone = analysis::factorOf("participant", std::vector<std::string>(12, "1"));
  const auto why = reasonOf({1, 2, 3, 3, 4, 5, 2, 3, 1, 5, 3, 4}, {alone});
  EXPECT_EQ(why, analysis::reason("one_random_level", "participant"));
}

TEST(CumulativeLinkUndefined, NamesAVarianceThatIsEstimatedAsZero) {
  // Both participants give the same answers.
  const auto result = analysis::fitCumulativeLinkMixedModel(
      std::vector<int>{1, 2, 3, 3, 4, 2, 1, 2, 3, 3, 4, 2},
      methods(),
      {{analysis::factorOf("participant", kPerson)}});

  ASSERT_TRUE(result.fit) << base::describe(result.reason);
  EXPECT_TRUE(result.fit->components[0].isSingular);
  const auto plain = analysis::fitCumulativeLinkMixedModel(
      std::vector<int>{1, 2, 3, 3, 4, 2, 1, 2, 3, 3, 4, 2}, methods(), {});
  EXPECT_NEAR(result.fit->logLikelihood, plain.fit.value().logLikelihood, 1e-10);
  EXPECT_NEAR(
      result.fit->fixedEffects[0].standardError, plain.fit->fixedEffects[0].standardError, 1e-6);
}

TEST(CumulativeLinkUndefined, HasNoThresholdForALevelWithoutAnswers) {
  const std::vector<int> y{1, 2, 5, 2, 5, 5, 1, 2, 2, 1, 5, 2};
  const auto fit = analysis::fitCumulativeLinkMixedModel(y, methods(), {}).fit.value();

  ASSERT_EQ(fit.thresholds.size(), 2U);
  EXPECT_EQ(fit.thresholds[0].name, "1|2");
  EXPECT_EQ(fit.thresholds[1].name, "2|5");
}

/// Two levels and one factor: the logistic regression, whose estimates are known.
TEST(CumulativeLink, OfTwoLevelsIsTheOddsRatioOfATable) {
  const std::vector<int> y{1, 1, 2, 1, 2, 2, 1, 2, 1, 2, 2, 2};  // a: 4 to 2, b: 1 to 5
  const auto fit = analysis::fitCumulativeLinkMixedModel(y, methods(), {}).fit.value();

  EXPECT_NEAR(fit.thresholds[0].estimate, std::log(4.0 / 2.0), 1e-9);
  EXPECT_NEAR(fit.fixedEffects[0].oddsRatio, (5.0 / 1.0) / (2.0 / 4.0), 1e-7);
  const double standardError = std::sqrt(1.0 / 4 + 1.0 / 2 + 1.0 / 1 + 1.0 / 5);  // Woolf 1955
  EXPECT_NEAR(fit.fixedEffects[0].standardError, standardError, 1e-6);
  const auto interval = analysis::oddsRatioInterval(fit.fixedEffects[0], 0.95);
  EXPECT_NEAR(interval.high, 10.0 * std::exp(1.959963984540054 * standardError), 1e-3);
  const auto difference = contrast(fit, "a - b", methods().difference("method", "a", "b"));
  EXPECT_NEAR(difference.estimate, -fit.fixedEffects[0].estimate, 1e-12);
  EXPECT_NEAR(difference.standardError, standardError, 1e-6);
}

TEST(CumulativeLink, ThrowsForInvalidArguments) {
  EXPECT_THROW(
      analysis::fitCumulativeLinkMixedModel(std::vector<int>{1, 2}, methods(), {}),
      std::invalid_argument);
  const analysis::CumulativeLinkFit fit;
  EXPECT_THROW(contrast(fit, "", std::vector<double>{1.0}), std::invalid_argument);
  EXPECT_THROW(analysis::confidenceInterval(analysis::WaldEstimate{}, 0.0), std::invalid_argument);
}

}  // namespace cumulative_link_undefined_test
