#include "questionnaires/scoring/scoring.h"

#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/questionnaires/shipped_instruments.h"

namespace questionnaires {
namespace scoring_test {

/// The same answer to every item.
std::vector<Answer> all(const Instrument& instrument, const Response& response) {
  std::vector<Answer> answers;
  for (const auto& item : instrument.items) answers.push_back({item.id, response});
  return answers;
}

std::optional<double> scoreOf(
    const Instrument& instrument, std::string_view id, const std::vector<Answer>& answers) {
  for (const auto& score : instrument.scores) {
    if (score.id == id) return scoreValue(instrument, score, answers);
  }
  ADD_FAILURE() << "there is no score " << id;
  return std::nullopt;
}

/// Two points for and one against, 1…5.
const Instrument kThree{
    .items = {
        {.id = "a"},
        {.id = "b"},
        {.id = "c", .key = -1},
        {.id = "why", .type = ItemType::LongText}}};
const Score kMean{.id = "mean", .items = {"a", "b", "c"}};

std::vector<Answer> points(std::vector<std::optional<std::int64_t>> given) {
  const std::vector<std::string> ids{"a", "b", "c"};
  std::vector<Answer> answers;
  for (std::size_t i = 0; i < given.size(); ++i) {
    answers.push_back({ids[i], given[i] ? std::optional<Response>(*given[i]) : std::nullopt});
  }
  return answers;
}

// Points whose scores follow from the published keys by hand.

TEST(RawTlx, IsZeroWhereEverySliderIs) {
  const auto& tlx = tests::shipped().at("nasa-tlx-raw");
  EXPECT_EQ(scoreOf(tlx, "workload", all(tlx, 0.0)), 0.0);
}

TEST(RawTlx, IsAHundredWhereEverySliderIs) {
  const auto& tlx = tests::shipped().at("nasa-tlx-raw");
  EXPECT_EQ(scoreOf(tlx, "workload", all(tlx, 100.0)), 100.0);
}

TEST(RawTlx, CountsFailureAsWorkload) {
  const auto& tlx = tests::shipped().at("nasa-tlx-raw");
  auto answers = all(tlx, 0.0);
  answers[3] = {"performance", 60.0};
  EXPECT_EQ(scoreOf(tlx, "workload", answers), 10.0);  // 60 / 6
}

TEST(RawTlx, CountsTheTwentyOneTicksOfThePaperForm) {
  // (x - 1) · 5
  Instrument ticks;
  for (const auto* id : {"a", "b", "c", "d", "e", "f"}) {
    ticks.items.push_back({.id = id, .scale = {.lowest = 1, .points = 21}});
  }
  const Score score{
      .items = {"a", "b", "c", "d", "e", "f"}, .reverseByKey = false, .offset = -1, .factor = 5};
  EXPECT_EQ(scoreValue(ticks, score, all(ticks, std::int64_t{1})), 0.0);
  EXPECT_EQ(scoreValue(ticks, score, all(ticks, std::int64_t{21})), 100.0);
  EXPECT_EQ(scoreValue(ticks, score, all(ticks, std::int64_t{8})), 35.0);
}

TEST(UeqShort, IsThreeWhereEveryPairIsSeven) {
  const auto& ueq = tests::shipped().at("ueq-s");
  const auto answers = all(ueq, std::int64_t{7});
  EXPECT_EQ(scoreOf(ueq, "pragmatic", answers), 3.0);
  EXPECT_EQ(scoreOf(ueq, "hedonic", answers), 3.0);
  EXPECT_EQ(scoreOf(ueq, "overall", answers), 3.0);
}

TEST(UeqShort, IsMinusThreeWhereEveryPairIsOne) {
  const auto& ueq = tests::shipped().at("ueq-s");
  EXPECT_EQ(scoreOf(ueq, "overall", all(ueq, std::int64_t{1})), -3.0);
}

TEST(UeqShort, KeepsItsHalvesApart) {
  const auto& ueq = tests::shipped().at("ueq-s");
  auto answers = all(ueq, std::int64_t{7});
  for (std::size_t i = 4; i < 8; ++i) answers[i].response = std::int64_t{3};
  EXPECT_EQ(scoreOf(ueq, "pragmatic", answers), 3.0);
  EXPECT_EQ(scoreOf(ueq, "hedonic", answers), -1.0);
  EXPECT_EQ(scoreOf(ueq, "overall", answers), 1.0);
}

TEST(PunchFaceValidity, IsBestWhereEveryoneAgreesWithWhatSpeaksForIt) {
  const auto& punch = tests::shipped().at("punch-face-validity");
  const std::vector<Answer> answers{
      {"1.1", std::int64_t{5}}, {"1.2", std::int64_t{1}}, {"1.3", std::int64_t{5}}};
  EXPECT_EQ(scoreOf(punch, "face-validity-1", answers), 5.0);
  EXPECT_FALSE(scoreOf(punch, "face-validity-2", answers).has_value());
}

TEST(Scored, ReversesItemsWordedAgainst) {
  EXPECT_EQ(scoreValue(kThree, kMean, points({5, 4, 1})), 14.0 / 3.0);  // 5, 4, 6 - 1
}

TEST(Scored, LeavesTheKeyAloneWhereItIsTold) {
  const Score score{.items = {"a", "b", "c"}, .reverseByKey = false};
  EXPECT_EQ(scoreValue(kThree, score, points({5, 4, 1})), 10.0 / 3.0);
}

TEST(Scored, AddsAndThenMultiplies) {
  const Score score{.items = {"a"}, .offset = -1.0, .factor = 25.0};
  EXPECT_EQ(scoreValue(kThree, score, points({4})), 75.0);  // (4 - 1) · 25
}

TEST(Scored, SumsWhereItIsTold) {
  const Score score{.items = {"a", "b", "c"}, .aggregate = Score::Aggregate::Sum};
  EXPECT_EQ(scoreValue(kThree, score, points({5, 4, 1})), 14.0);
}

TEST(Scored, NeedsEveryAnswerUnlessItIsToldOtherwise) {
  EXPECT_FALSE(scoreValue(kThree, kMean, points({5, 4})).has_value());
  EXPECT_FALSE(scoreValue(kThree, kMean, points({5, 4, std::nullopt})).has_value());
  EXPECT_FALSE(scoreValue(kThree, kMean, {}).has_value());
}

TEST(Scored, TakesAMissingAnswerNeitherForTheMiddleNorForZero) {
  const Score score{.items = {"a", "b", "c"}, .leastAnswered = 2};
  EXPECT_EQ(scoreValue(kThree, score, points({5, std::nullopt, 1})), 5.0);
  EXPECT_FALSE(scoreValue(kThree, score, points({5, std::nullopt, std::nullopt})).has_value());
}

TEST(Scored, NeverSumsWithAnAnswerMissing) {
  const Score score{
      .items = {"a", "b", "c"}, .aggregate = Score::Aggregate::Sum, .leastAnswered = 1};
  EXPECT_FALSE(scoreValue(kThree, score, points({5, 4})).has_value());
  EXPECT_EQ(scoreValue(kThree, score, points({5, 4, 1})), 14.0);
}

TEST(Scored, CountsNoAnswerThatIsNone) {
  const Score score{.items = {"a", "b"}, .leastAnswered = 1};
  EXPECT_EQ(scoreValue(kThree, score, points({4, 9})), 4.0);
  EXPECT_EQ(scoreValue(kThree, score, {{"a", std::int64_t{4}}, {"b", "much"}}), 4.0);
  EXPECT_FALSE(scoreValue(kThree, {.items = {"why"}}, {{"why", "5"}}).has_value());
  EXPECT_FALSE(scoreValue(kThree, {.items = {"unknown"}}, {{"unknown", 5.0}}).has_value());
}

TEST(Scored, TakesTheLastOfSeveralAnswers) {
  const std::vector<Answer> answers{{"a", std::int64_t{1}}, {"a", std::int64_t{4}}};
  EXPECT_EQ(scoreValue(kThree, {.items = {"a"}}, answers), 4.0);
}

TEST(Scored, HonoursAnAnswerThatWasTakenBack) {
  const std::vector<Answer> answers{{"a", std::int64_t{1}}, {"a", std::nullopt}};
  EXPECT_FALSE(scoreValue(kThree, {.items = {"a"}}, answers).has_value());
}

TEST(Scored, ReversesASliderBetweenItsEnds) {
  const Instrument instrument{
      .items = {{.id = "s", .type = ItemType::Slider, .key = -1, .least = -10.0, .most = 30.0}}};
  EXPECT_EQ(scoreValue(instrument, {.items = {"s"}}, {{"s", 25.0}}), -5.0);  // -10 + 30 - 25
}

TEST(Scored, WeighsWhereItIsTold) {
  Score score{.items = {"a", "b", "c"}, .weights = {1.0, 2.0, 0.5}};
  EXPECT_EQ(scoreValue(kThree, score, points({5, 4, 1})), 15.5 / 3.5);  // 5 + 2·4 + 0.5·(6 - 1)
  score.aggregate = Score::Aggregate::Sum;
  EXPECT_EQ(scoreValue(kThree, score, points({5, 4, 1})), 15.5);
}

TEST(Scored, WeighsOnlyWhatWasAnsweredInAMean) {
  const Score score{.items = {"a", "b", "c"}, .leastAnswered = 1, .weights = {1.0, 3.0, 0.0}};
  EXPECT_EQ(scoreValue(kThree, score, points({5, 1})), 2.0);  // (5 + 3·1) / 4
  EXPECT_EQ(scoreValue(kThree, score, points({5})), 5.0);
  const auto result = computeScore(kThree, score, points({std::nullopt, std::nullopt, 1}));
  EXPECT_FALSE(result.value.has_value());
  EXPECT_EQ(result.reason, "every item that was answered has the weight 0");
}

TEST(Scored, CountsFromAThreshold) {
  const Score score{
      .items = {"a", "b", "c"}, .aggregate = Score::Aggregate::Count, .countFrom = 4.0};
  EXPECT_EQ(scoreValue(kThree, score, points({4, 3, 1})), 2.0);  // 4 and 6 - 1
  EXPECT_EQ(scoreValue(kThree, score, points({1, 1, 5})), 0.0);
  EXPECT_FALSE(scoreValue(kThree, score, points({4, 3})).has_value());
}

TEST(Scored, ReplacesWhatIsMissingBeforeItIsTurnedRound) {
  const Score score{
      .items = {"a", "b", "c"},
      .aggregate = Score::Aggregate::Sum,
      .leastAnswered = 1,
      .missingAs = 2.0};
  const auto result = computeScore(kThree, score, points({5}));
  EXPECT_EQ(result.value, 11.0);  // 5 + 2 + (6 - 2)
  EXPECT_EQ(result.answered, 1U);
  EXPECT_FALSE(scoreValue(kThree, score, {}).has_value());
}

TEST(Scored, SaysWhyThereIsNoValue) {
  const auto result = computeScore(kThree, kMean, points({5, 4}));
  EXPECT_FALSE(result.value.has_value());
  EXPECT_EQ(result.reason, "2 of 3 items were answered; this score needs 3");
  EXPECT_EQ(computeScore(kThree, kMean, points({5, 4, 1})).reason, "");
}

TEST(Scored, HasNoWeightsFromPairsThatAreNone) {
  const Score noPairs{.items = {"a", "b"}};
  EXPECT_FALSE(pairWeights(kThree, noPairs, points({5, 4})).has_value());
  const Score wrongPairs{.items = {"a", "b"}, .weightsFrom = {"c"}};
  EXPECT_FALSE(pairWeights(kThree, wrongPairs, points({5, 4, 1})).has_value());
  EXPECT_FALSE(scoreValue(kThree, wrongPairs, points({5, 4, 1})).has_value());
}

TEST(ScoreChange, SaysWhichTimeIsMissing) {
  const auto all = points({5, 4, 1});
  const auto some = points({5, 4});
  const auto noBefore = scoreChange(kThree, kMean, some, all);
  EXPECT_FALSE(noBefore.change.has_value());
  EXPECT_EQ(noBefore.after, 14.0 / 3.0);
  EXPECT_EQ(noBefore.reason.find("before: 2 of 3"), 0U);
  EXPECT_EQ(scoreChange(kThree, kMean, all, some).reason.find("after: 2 of 3"), 0U);
  EXPECT_EQ(scoreChange(kThree, kMean, all, points({2, 2, 2})).change, 8.0 / 3.0 - 14.0 / 3.0);
}

TEST(Scored, NeverYieldsNan) {
  const Instrument instrument{.items = {{.id = "n", .type = ItemType::Number}}};
  EXPECT_FALSE(scoreValue(instrument, {.items = {"n"}}, {{"n", NAN}}).has_value());
  EXPECT_FALSE(scoreValue(instrument, {.items = {}}, {}).has_value());
}

TEST(ScoreRange, IsThatOfTheAuthors) {
  const auto rangeIn = [](const std::string& instrument, const std::string& score) {
    const auto& shipped = tests::shipped().at(instrument);
    return rangeOf(shipped, *shipped.score(score));
  };
  EXPECT_EQ(rangeIn("sus", "sus"), (Range{0.0, 100.0}));
  EXPECT_EQ(rangeIn("sus", "learnability"), (Range{0.0, 100.0}));
  EXPECT_EQ(rangeIn("nasa-tlx-raw", "workload"), (Range{0.0, 100.0}));
  EXPECT_EQ(rangeIn("nasa-tlx-weighted", "workload"), (Range{0.0, 100.0}));
  EXPECT_EQ(rangeIn("ueq-s", "overall"), (Range{-3.0, 3.0}));
}

}  // namespace scoring_test
}  // namespace questionnaires
