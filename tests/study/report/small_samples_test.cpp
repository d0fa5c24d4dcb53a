// What a report leaves out for few people.
#include "study/report/small_samples.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "analysis/registry/registry.h"
#include "study/report/study_parts.h"
#include "tests/study/report/section.h"

namespace small_samples_test {
namespace {

using study::report::leaveOutSmallSamples;
using study::report::leftOutInWords;

/// The made-up section with @p people in its first cohort, who are compared with the second.
study::report::ReportSection sectionOf(std::size_t people) {
  auto section = tests::madeUpSection();
  auto& family = section.results.families.front();
  auto& cohort = family.cohorts.front();
  std::erase_if(
      cohort.table.answers, [&](const auto& answer) { return answer.participant >= people; });
  cohort.within = analysis::compareWithin(
      cohort.table, std::vector<analysis::DeclaredPair>{{"interpolation", "kalman"}}, {});
  cohort.checks = analysis::scaleChecks(cohort.table);
  study::BetweenResult between{
      .condition = "kalman", .cohort1 = "professional", .cohort2 = "non-professional", .tests = {}};
  const analysis::TestData data{
      .values = {
          {.name = "professional", .values = std::vector<double>(people, 1.0)},
          {.name = "non-professional", .values = {1.0, 2.0, 3.0, 4.0, 5.0}}}};
  for (const auto* id : {"mann_whitney", "brunner_munzel"}) {
    for (auto& row : computeTest(analysis::statisticalTest(id), data, {})) {
      between.tests.push_back(std::move(row));
    }
  }
  family.between.push_back(std::move(between));
  return section;
}

TEST(SmallSamples, OfOneVoteHaveNoTest) {
  auto results = tests::madeUpSection().results;
  ASSERT_TRUE(results.votes.front().test.exactP);
  results.votes.back().votes = analysis::VoteCounts({"interpolation", "kalman"});
  results.votes.back().votes.add("kalman", 1);
  leaveOutSmallSamples(results, {});
  EXPECT_TRUE(results.votes.front().test.exactP);
  EXPECT_FALSE(results.votes.back().test.exactP);
}

TEST(SmallSamples, OfFourHaveExactTestsAndNoApproximations) {
  auto results = sectionOf(4).results;
  const auto& family = results.families.front();
  const auto& pair = family.cohorts.front().within.rows.front();
  ASSERT_TRUE(pair.test("ordinal_model").p);
  ASSERT_TRUE(family.between.front().test("brunner_munzel").p);
  leaveOutSmallSamples(results, {});
  EXPECT_FALSE(pair.test("ordinal_model").p);
  EXPECT_EQ(base::describe(pair.test("ordinal_model").reason), "it needs at least 5 participants");
  EXPECT_FALSE(family.between.front().test("brunner_munzel").p);
  EXPECT_FALSE(family.cohorts.front().checks.methods.front().alpha.value);
  EXPECT_TRUE(pair.test("sign_flip").p);
  EXPECT_TRUE(family.between.front().test("mann_whitney").p);
  EXPECT_EQ(
      leftOutInWords(family, {}),
      "Left out where a cohort is too small: Brunner and Munzel's test; Cronbach's alpha; "
      "Cumulative link mixed model (each needs at least 5 participants).");
}

TEST(SmallSamples, OfFiveKeepEverything) {
  auto results = sectionOf(5).results;
  leaveOutSmallSamples(results, {});
  const auto& family = results.families.front();
  EXPECT_TRUE(family.cohorts.front().within.rows.front().test("ordinal_model").p);
  EXPECT_TRUE(family.between.front().test("brunner_munzel").p);
  EXPECT_TRUE(family.cohorts.back().checks.methods.front().alpha.reason.key() != "fewer_people");
  EXPECT_EQ(leftOutInWords(family, {}), "");
}

/// The scores of one participant who answered everything, about one condition.
study::InstrumentSummary scoresOf(
    const questionnaires::Instrument& instrument, std::size_t people, const std::string& cohort) {
  study::InstrumentSummary summary{.instrument = instrument.id};
  for (const auto& score : instrument.scores) {
    summary.scores.push_back(
        {.score = score.id,
         .cohort = cohort,
         .condition = "kalman",
         .values = std::vector<double>(people, 3.0),
         .mean = 3.0});
  }
  return summary;
}

std::vector<std::string> idsOf(const std::vector<study::ScoreSummary>& scores) {
  std::vector<std::string> ids;
  for (const auto& score : scores) ids.push_back(score.score + " of " + score.cohort);
  return ids;
}

/// The first of the compared items in some scores, then pairs of them: from the first and second,
/// first and third, second and third the answers to all three follow.
TEST(SmallSamples, OfOnePersonHaveNoScoreThatGivesAnAnswerAway) {
  auto section = tests::madeUpSection();
  const auto& family = section.results.families.front().family;
  auto& instrument =
      *std::ranges::find(section.instruments, family.instrument, &questionnaires::Instrument::id);
  std::vector<std::string> all;
  for (const auto& item : protocols::comparedItems(family, instrument.items)) {
    all.push_back(item.id);
  }
  ASSERT_GE(all.size(), 6U);
  const auto firstItems = [&](std::size_t count) {
    return std::vector(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count));
  };
  const std::vector<std::pair<std::string, std::vector<std::string>>> scores{
      {"all", all},
      {"all but one", firstItems(all.size() - 1)},
      {"all but two", firstItems(all.size() - 2)},
      {"one", firstItems(1)},
      {"two", firstItems(2)},
      {"three", firstItems(3)},
      {"first and third", {all[0], all[2]}},
      {"second and third", {all[1], all[2]}}};
  instrument.scores.resize(scores.size());
  for (std::size_t i = 0; i < scores.size(); ++i) {
    instrument.scores[i].id = scores[i].first;
    instrument.scores[i].items = scores[i].second;
  }
  auto alone = scoresOf(instrument, 1, "professional");
  for (auto& one : scoresOf(instrument, 2, "non-professional").scores) {
    alone.scores.push_back(std::move(one));
  }
  alone.acceptable = {{.cohort = "professional", .item = {.itemId = "1.1", .answered = 1}}};
  section.results.instruments = {alone};
  leaveOutSmallSamples(section.results, section.instruments);
  const auto& left = section.results.instruments.front();
  EXPECT_EQ(
      idsOf(left.scores),
      (std::vector<std::string>{
          "all of professional",
          "all but two of professional",
          "two of professional",
          "first and third of professional",
          "all of non-professional",
          "all but one of non-professional",
          "all but two of non-professional",
          "one of non-professional",
          "two of non-professional",
          "three of non-professional",
          "first and third of non-professional",
          "second and third of non-professional"}));
  EXPECT_TRUE(left.acceptable.empty());
}

TEST(SmallSamples, AreMentionedBesideTheTests) {
  auto section = sectionOf(4);
  leaveOutSmallSamples(section.results, section.instruments);
  const auto page = study::report::familyAsHtml(section, section.results.families.front(), {});
  EXPECT_NE(page.find("<p>Left out where a cohort is too small:"), std::string::npos);
}

}  // namespace
}  // namespace small_samples_test
