// What a report leaves out for few people.
#include "study/report/small_samples.h"

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
  leaveOutSmallSamples(results);
  EXPECT_TRUE(results.votes.front().test.exactP);
  EXPECT_FALSE(results.votes.back().test.exactP);
}

TEST(SmallSamples, OfFourHaveExactTestsAndNoApproximations) {
  auto results = sectionOf(4).results;
  const auto& family = results.families.front();
  const auto& pair = family.cohorts.front().within.rows.front();
  ASSERT_TRUE(pair.test("ordinal_model").p);
  ASSERT_TRUE(family.between.front().test("brunner_munzel").p);
  leaveOutSmallSamples(results);
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
  leaveOutSmallSamples(results);
  const auto& family = results.families.front();
  EXPECT_TRUE(family.cohorts.front().within.rows.front().test("ordinal_model").p);
  EXPECT_TRUE(family.between.front().test("brunner_munzel").p);
  EXPECT_TRUE(family.cohorts.back().checks.methods.front().alpha.reason.key() != "fewer_people");
  EXPECT_EQ(leftOutInWords(family, {}), "");
}

TEST(SmallSamples, AreMentionedBesideTheTests) {
  auto section = sectionOf(4);
  leaveOutSmallSamples(section.results);
  const auto page = study::report::familyAsHtml(section, section.results.families.front(), {});
  EXPECT_NE(page.find("<p>Left out where a cohort is too small:"), std::string::npos);
}

}  // namespace
}  // namespace small_samples_test
