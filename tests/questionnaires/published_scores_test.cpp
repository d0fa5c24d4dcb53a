// The shipped instruments, scored as their authors key them.
#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "questionnaires/scoring/scoring.h"
#include "tests/questionnaires/shipped_instruments.h"

namespace questionnaires {
namespace published_scores_test {

/// The points of @p points, item by item.
std::vector<Answer> given(const Instrument& instrument, const std::vector<std::int64_t>& points) {
  std::vector<Answer> answers;
  for (std::size_t i = 0; i < points.size(); ++i) {
    answers.push_back({instrument.items.at(i).id, points[i]});
  }
  return answers;
}

/// The same answer to every item that is answered with points or numbers.
std::vector<Answer> all(const Instrument& instrument, std::int64_t point) {
  std::vector<Answer> answers;
  for (const auto& item : instrument.items) {
    if (item.type != ItemType::PairwiseChoice) answers.push_back({item.id, point});
  }
  return answers;
}

std::optional<double> scoreOf(
    const Instrument& instrument, std::string_view id, const std::vector<Answer>& answers) {
  const Score* score = instrument.score(id);
  if (score == nullptr) {
    ADD_FAILURE() << instrument.id << " has no score " << id;
    return std::nullopt;
  }
  return scoreValue(instrument, *score, answers);
}

/// The numbers, counted from 1, of the items of a score; those of the shipped instruments stand in
/// the published order.
std::set<int> numbersOf(const Instrument& instrument, std::string_view id) {
  std::set<int> numbers;
  for (const auto& item : instrument.score(id)->items) {
    const auto place = instrument.item(item) - instrument.items.data();
    numbers.insert(static_cast<int>(place) + 1);
  }
  return numbers;
}

std::set<int> reversedOf(const Instrument& instrument) {
  std::set<int> numbers;
  for (std::size_t i = 0; i < instrument.items.size(); ++i) {
    if (instrument.items[i].key == -1) numbers.insert(static_cast<int>(i) + 1);
  }
  return numbers;
}

const Instrument& kWeightedTlx = tests::shipped().at("nasa-tlx-weighted");
const Instrument& kSus = tests::shipped().at("sus");
const Instrument& kUeq = tests::shipped().at("ueq");
const Instrument& kIpq = tests::shipped().at("ipq");
const Instrument& kSsq = tests::shipped().at("ssq");
const Instrument& kPresence = tests::shipped().at("slater-usoh-steed");

/// All fifteen pairs; in each the dimension wins that stands first in @p order.
std::vector<Answer> pairsBy(const std::vector<std::string>& order) {
  std::vector<Answer> answers;
  for (const auto& item : kWeightedTlx.items) {
    if (item.type != ItemType::PairwiseChoice) continue;
    const auto rank = [&](const Option& option) {
      return std::find(order.begin(), order.end(), option.id) - order.begin();
    };
    const bool isFirst = rank(item.options[0]) < rank(item.options[1]);
    answers.push_back({item.id, item.options[isFirst ? 0 : 1].id});
  }
  return answers;
}

const std::vector<std::string> kOrder{
    "effort", "mental-demand", "frustration", "performance", "temporal-demand", "physical-demand"};

TEST(WeightedTlx, AsksEveryPairOfSixOnce) {
  std::set<std::set<std::string>> pairs;
  for (const auto& item : kWeightedTlx.items) {
    if (item.type == ItemType::PairwiseChoice) {
      pairs.insert({item.options[0].id, item.options[1].id});
    }
  }
  EXPECT_EQ(pairs.size(), 15U);
  EXPECT_EQ(kWeightedTlx.score("workload")->weightsFrom.size(), 15U);
}

TEST(WeightedTlx, HasWeightsThatSumToFifteen) {
  const auto weights = pairWeights(kWeightedTlx, *kWeightedTlx.score("workload"), pairsBy(kOrder));
  // mental, physical, temporal, performance, effort, frustration
  EXPECT_EQ(weights, (std::vector<double>{4, 0, 1, 2, 5, 3}));
}

TEST(WeightedTlx, DividesTheWeightedSumByFifteen) {
  auto answers = pairsBy(kOrder);
  const std::vector<double> ratings{80.0, 100.0, 30.0, 25.0, 60.0, 45.0};
  for (std::size_t i = 0; i < 6; ++i) answers.push_back({kWeightedTlx.items[i].id, ratings[i]});
  // (4·80 + 0·100 + 1·30 + 2·25 + 5·60 + 3·45) / 15
  EXPECT_EQ(scoreOf(kWeightedTlx, "workload", answers), 835.0 / 15.0);
  EXPECT_EQ(scoreOf(kWeightedTlx, "workload-raw", answers), 340.0 / 6.0);
}

TEST(WeightedTlx, IsTheRatingItselfWhereAllRatingsAreAlike) {
  for (const std::int64_t rating : {0, 35, 100}) {
    auto answers = all(kWeightedTlx, rating);
    for (const auto& answer : pairsBy(kOrder)) answers.push_back(answer);
    EXPECT_EQ(scoreOf(kWeightedTlx, "workload", answers), static_cast<double>(rating));
  }
}

TEST(WeightedTlx, NeedsEveryPairAndEveryRating) {
  auto answers = pairsBy(kOrder);
  for (std::size_t i = 0; i < 6; ++i) answers.push_back({kWeightedTlx.items[i].id, 50.0});
  answers.back().response = std::nullopt;
  EXPECT_FALSE(scoreOf(kWeightedTlx, "workload", answers).has_value());
  answers.back().response = 50.0;
  EXPECT_TRUE(scoreOf(kWeightedTlx, "workload", answers).has_value());
  answers.front().response = std::nullopt;
  const auto result = computeScore(kWeightedTlx, *kWeightedTlx.score("workload"), answers);
  EXPECT_FALSE(result.value.has_value());
  EXPECT_EQ(result.reason, "a pair was left open, and the weights come from all of them");
}

TEST(SimTlx, IsAHundredWhereEveryRatingIsTwenty) {
  const auto& sim = tests::shipped().at("sim-tlx");
  EXPECT_EQ(sim.items.size(), 9U);
  EXPECT_EQ(scoreOf(sim, "workload", all(sim, 20)), 20.0);
  EXPECT_EQ(scoreOf(sim, "workload-percent", all(sim, 20)), 100.0);
  EXPECT_EQ(scoreOf(sim, "workload-percent", all(sim, 0)), 0.0);
}

TEST(Sus, IsFiftyInTheMiddle) {
  for (const auto* score : {"sus", "usability", "learnability"}) {
    EXPECT_EQ(scoreOf(kSus, score, all(kSus, 3)), 50.0) << score;
  }
}

TEST(Sus, IsAHundredWhereEveryOddIsFiveAndEveryEvenIsOne) {
  const auto best = given(kSus, {5, 1, 5, 1, 5, 1, 5, 1, 5, 1});
  const auto worst = given(kSus, {1, 5, 1, 5, 1, 5, 1, 5, 1, 5});
  for (const auto* score : {"sus", "usability", "learnability"}) {
    EXPECT_EQ(scoreOf(kSus, score, best), 100.0) << score;
    EXPECT_EQ(scoreOf(kSus, score, worst), 0.0) << score;
  }
}

TEST(Sus, CountsAMissingAnswerAsTheMiddle) {
  for (std::size_t missing = 0; missing < 10; ++missing) {
    auto answers = given(kSus, {5, 1, 5, 1, 5, 1, 5, 1, 5, 1});
    answers[missing].response = std::nullopt;
    const auto result = computeScore(kSus, *kSus.score("sus"), answers);
    EXPECT_EQ(result.value, 95.0) << missing;
    EXPECT_EQ(result.answered, 9U);
  }
}

TEST(Sus, IsUndefinedIfFewerThanHalfAreAnswered) {
  EXPECT_TRUE(scoreOf(kSus, "sus", given(kSus, {5, 1, 5, 1, 5})).has_value());
  const auto result = computeScore(kSus, *kSus.score("sus"), given(kSus, {5, 1, 5, 1}));
  EXPECT_FALSE(result.value.has_value());
  EXPECT_EQ(result.reason, "4 of 10 items were answered; this score needs 5");
}

TEST(Sus, HasLearnabilityFromItemsFourAndTen) {
  EXPECT_EQ(numbersOf(kSus, "learnability"), (std::set<int>{4, 10}));
  EXPECT_EQ(numbersOf(kSus, "usability"), (std::set<int>{1, 2, 3, 5, 6, 7, 8, 9}));
  const auto answers = given(kSus, {5, 1, 5, 5, 5, 1, 5, 1, 5, 5});
  EXPECT_EQ(scoreOf(kSus, "usability", answers), 100.0);
  EXPECT_EQ(scoreOf(kSus, "learnability", answers), 0.0);
  EXPECT_EQ(scoreOf(kSus, "sus", answers), 80.0);  // 32 · 2.5
}

TEST(Ueq, ReversesTheThirteenWithThePositiveWordOnTheLeft) {
  EXPECT_EQ(reversedOf(kUeq), (std::set<int>{3, 4, 5, 9, 10, 12, 17, 18, 19, 21, 23, 24, 25}));
}

TEST(Ueq, HasSixScalesAndNoTotal) {
  EXPECT_EQ(kUeq.items.size(), 26U);
  EXPECT_EQ(kUeq.scores.size(), 6U);
  EXPECT_EQ(numbersOf(kUeq, "attractiveness"), (std::set<int>{1, 12, 14, 16, 24, 25}));
  EXPECT_EQ(numbersOf(kUeq, "perspicuity"), (std::set<int>{2, 4, 13, 21}));
  EXPECT_EQ(numbersOf(kUeq, "efficiency"), (std::set<int>{9, 20, 22, 23}));
  EXPECT_EQ(numbersOf(kUeq, "dependability"), (std::set<int>{8, 11, 17, 19}));
  EXPECT_EQ(numbersOf(kUeq, "stimulation"), (std::set<int>{5, 6, 7, 18}));
  EXPECT_EQ(numbersOf(kUeq, "novelty"), (std::set<int>{3, 10, 15, 26}));
}

TEST(Ueq, IsThreeWhereThePositiveWordIsChosenThroughout) {
  auto answers = all(kUeq, 7);
  for (const int number : reversedOf(kUeq)) {
    answers[static_cast<std::size_t>(number) - 1].response = std::int64_t{1};
  }
  for (const auto& score : kUeq.scores)
    EXPECT_EQ(scoreValue(kUeq, score, answers), 3.0) << score.id;
  for (const auto& score : kUeq.scores) EXPECT_EQ(scoreValue(kUeq, score, all(kUeq, 4)), 0.0);
}

TEST(Ueq, WarnsIfEveryAnswerIsTheSamePoint) {
  // Every scale has positive words on both sides: 7 and 8 - 7 lie 6 apart.
  const auto finding = consistencyOf(kUeq, all(kUeq, 7));
  ASSERT_TRUE(finding.has_value());
  EXPECT_TRUE(finding->isSuspicious);
  EXPECT_EQ(finding->contradictoryScores.size(), 6U);
  EXPECT_NE(finding->warning.find("in 6 of 6 scales"), std::string::npos);
}

TEST(Ueq, AcceptsContradictionsInTwoScales) {
  auto answers = all(kUeq, 4);
  answers[0].response = std::int64_t{7};  // attractiveness: 7 and 3, 4 apart
  answers[13].response = std::int64_t{3};
  answers[1].response = std::int64_t{7};  // perspicuity: 7 and 3 of 8 - 5, 4 apart
  answers[3].response = std::int64_t{5};
  EXPECT_FALSE(consistencyOf(kUeq, answers)->isSuspicious);
  answers[19].response = std::int64_t{7};  // efficiency: 7 and 4, 3 apart: not above 3
  EXPECT_EQ(consistencyOf(kUeq, answers)->contradictoryScores.size(), 2U);
  answers[21].response = std::int64_t{3};  // efficiency: 7 and 3
  EXPECT_TRUE(consistencyOf(kUeq, answers)->isSuspicious);
}

TEST(Ipq, ReversesThreeAndLeavesFlippedAnchorsAlone) {
  for (const auto& item : kIpq.items) {
    const bool isReversed = item.id == "SP2" || item.id == "INV3" || item.id == "REAL1";
    EXPECT_EQ(item.key, isReversed ? -1 : 1) << item.id;
  }
}

TEST(Ipq, HasFourMeansAndNoTotal) {
  const auto answers = all(kIpq, 6);
  EXPECT_EQ(kIpq.items.size(), 14U);
  EXPECT_EQ(kIpq.scores.size(), 4U);
  EXPECT_EQ(scoreOf(kIpq, "general", answers), 6.0);
  EXPECT_EQ(scoreOf(kIpq, "spatial-presence", answers), 4.8);     // (0 + 4·6) / 5
  EXPECT_EQ(scoreOf(kIpq, "involvement", answers), 4.5);          // (0 + 3·6) / 4
  EXPECT_EQ(scoreOf(kIpq, "experienced-realism", answers), 4.5);  // (0 + 3·6) / 4
}

TEST(SlaterUsohSteed, GivesTheMeanAndTheNumberOfAnswersOfSixOrSeven) {
  const auto answers = given(kPresence, {7, 6, 5, 1, 6, 2});
  EXPECT_EQ(scoreOf(kPresence, "presence-mean", answers), 4.5);
  EXPECT_EQ(scoreOf(kPresence, "presence-count", answers), 3.0);
  EXPECT_EQ(scoreOf(kPresence, "presence-count", all(kPresence, 7)), 6.0);
  EXPECT_EQ(scoreOf(kPresence, "presence-count", all(kPresence, 5)), 0.0);
  EXPECT_FALSE(scoreOf(kPresence, "presence-count", given(kPresence, {7, 6, 5})).has_value());
}

TEST(Ssq, CountsTheSymptomsOfKennedy) {
  EXPECT_EQ(numbersOf(kSsq, "nausea"), (std::set<int>{1, 6, 7, 8, 9, 15, 16}));
  EXPECT_EQ(numbersOf(kSsq, "oculomotor"), (std::set<int>{1, 2, 3, 4, 5, 9, 11}));
  EXPECT_EQ(numbersOf(kSsq, "disorientation"), (std::set<int>{5, 8, 10, 11, 12, 13, 14}));
}

TEST(Ssq, HasThePublishedValuesWhereEverySymptomIsSevere) {
  const auto answers = all(kSsq, 3);
  EXPECT_DOUBLE_EQ(scoreOf(kSsq, "nausea", answers).value(), 200.34);
  EXPECT_DOUBLE_EQ(scoreOf(kSsq, "oculomotor", answers).value(), 159.18);
  EXPECT_DOUBLE_EQ(scoreOf(kSsq, "disorientation", answers).value(), 292.32);
  EXPECT_DOUBLE_EQ(scoreOf(kSsq, "total", answers).value(), 235.62);
}

TEST(Ssq, WeighsASymptomInTheTotalAsOftenAsItCounts) {
  for (std::size_t i = 0; i < 16; ++i) {
    auto answers = all(kSsq, 0);
    answers[i].response = std::int64_t{1};
    const double raw = scoreOf(kSsq, "nausea", answers).value() / 9.54 +
                       scoreOf(kSsq, "oculomotor", answers).value() / 7.58 +
                       scoreOf(kSsq, "disorientation", answers).value() / 13.92;
    EXPECT_DOUBLE_EQ(scoreOf(kSsq, "total", answers).value(), raw * 3.74) << i + 1;
  }
}

TEST(Ssq, IsScoredAsAChange) {
  EXPECT_EQ(kSsq.occasions, Occasions::BeforeAndAfter);
  auto before = all(kSsq, 0);
  before[7].response = std::int64_t{1};  // nausea: in N and in D
  auto after = before;
  after[7].response = std::int64_t{3};
  const auto change = scoreChange(kSsq, *kSsq.score("total"), before, after);
  EXPECT_DOUBLE_EQ(change.before.value(), 2 * 3.74);
  EXPECT_DOUBLE_EQ(change.after.value(), 6 * 3.74);
  EXPECT_DOUBLE_EQ(change.change.value(), 4 * 3.74);
}

}  // namespace published_scores_test
}  // namespace questionnaires
