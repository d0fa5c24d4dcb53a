#include "study/session/analysis_plan_history.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "study/results/results.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace plan_history_test {

using tests::MadeStudy;

/// The short protocol with one text replaced.
protocols::LoadedProtocol with(const std::string& text, const std::string& other) {
  auto json = tests::shortProtocol();
  json.replace(json.find(text), text.size(), other);
  return tests::protocolFrom(json);
}

protocols::LoadedProtocol stricter() {
  return with(R"("alpha": 0.05)", R"("alpha": 0.01)");
}

bool hasFlag(const Results& results) {
  const auto raised = flagsByKind(results.families.front(), true);
  return std::any_of(raised.begin(), raised.end(), [](const auto& one) {
    return one.flag->id == "family_not_declared";
  });
}

TEST(AnalysisPlanHistory, CountsChangesBeforeTheFirstLiveParticipantAsDeclared) {
  MadeStudy study;
  auto pilot = Session::enrol(*study, {.cohort = "surgeons", .runMode = RunMode::Pilot});
  tests::walkToTheEnd(pilot);
  study->amend(stricter(), "");
  const auto history = analysisPlanHistory(*study);
  EXPECT_EQ(history.versions, 2U);
  EXPECT_EQ(history.versionsSinceBegun, 0U);
  EXPECT_TRUE(history.changes.empty());
  EXPECT_TRUE(history.isDeclared("methods"));
  EXPECT_FALSE(hasFlag(computeResults(*study, RunMode::Pilot)));
}

TEST(AnalysisPlanHistory, ListsTheChangesOfALaterVersion) {
  MadeStudy study;
  auto person = Session::enrol(*study, {.cohort = "surgeons"});
  tests::walkToTheEnd(person);
  EXPECT_TRUE(computeResults(*study, RunMode::Live).families.front().isDeclared);
  study->amend(stricter(), "a reviewer asked");

  const auto history = analysisPlanHistory(*study);
  ASSERT_EQ(history.changes.size(), 1U);
  EXPECT_EQ(history.changes[0].family, "methods");
  EXPECT_EQ(history.changes[0].title, "Realism");
  EXPECT_EQ(history.changes[0].kind, FamilyChange::Kind::Changed);
  EXPECT_EQ(history.changes[0].keys, std::vector<std::string_view>{"alpha"});
  EXPECT_EQ(history.changes[0].before->alpha, 0.05);
  EXPECT_EQ(history.changes[0].after->alpha, 0.01);
  EXPECT_EQ(history.changes[0].participants, 1U);
  EXPECT_FALSE(history.isDeclared("methods"));
  const auto results = computeResults(*study, RunMode::Live);
  EXPECT_FALSE(results.families.front().isConfirmatory("welch"));
  EXPECT_TRUE(hasFlag(results));
}

TEST(AnalysisPlanHistory, CountsARestoredFamilyAsDeclared) {
  MadeStudy study;
  Session::enrol(*study, {.cohort = "surgeons"});
  study->amend(stricter(), "a reviewer asked");
  study->amend(tests::protocolFrom(tests::shortProtocol()), "an editor asked back");
  const auto history = analysisPlanHistory(*study);
  EXPECT_EQ(history.changes.size(), 2U);
  EXPECT_EQ(history.versionsSinceBegun, 2U);
  EXPECT_TRUE(history.isDeclared("methods"));
  EXPECT_EQ(history.changes[0].kind, FamilyChange::Kind::Changed);
  EXPECT_TRUE(history.changes[0].isHarmless);
  EXPECT_EQ(history.changes[1].kind, FamilyChange::Kind::Restored);
  EXPECT_TRUE(history.changes[1].isHarmless);
}

TEST(AnalysisPlanHistory, DoesNotCountAFamilyAsDeclaredIfAParticipantBeganWithAnotherForm) {
  MadeStudy study;
  Session::enrol(*study, {.cohort = "surgeons"});
  study->amend(stricter(), "a reviewer asked");
  Session::enrol(*study, {.cohort = "surgeons"});
  study->amend(tests::protocolFrom(tests::shortProtocol()), "an editor asked back");
  const auto history = analysisPlanHistory(*study);
  ASSERT_EQ(history.changes.size(), 2U);
  EXPECT_FALSE(history.isDeclared("methods"));
  EXPECT_FALSE(history.changes[0].isHarmless);
  EXPECT_EQ(history.changes[1].kind, FamilyChange::Kind::Restored);
  EXPECT_FALSE(history.changes[1].isHarmless);
}

TEST(AnalysisPlanHistory, CountsAFamilyAsDeclaredThatWasRemovedAndRestoredBeforeAnyParticipant) {
  MadeStudy study;
  Session::enrol(*study, {.cohort = "surgeons"});
  study->amend(with(R"("id": "methods")", R"("id": "afterthought")"), "a thought");
  study->amend(tests::protocolFrom(tests::shortProtocol()), "a second thought");
  const auto history = analysisPlanHistory(*study);
  ASSERT_EQ(history.changes.size(), 4U);
  EXPECT_EQ(history.changes[0].kind, FamilyChange::Kind::Added);
  EXPECT_FALSE(history.changes[0].isHarmless) << "it is in the protocol no longer";
  EXPECT_EQ(history.changes[2].family, "methods");
  EXPECT_EQ(history.changes[2].kind, FamilyChange::Kind::Restored);
  EXPECT_TRUE(history.isDeclared("methods"));
}

TEST(AnalysisPlanHistory, ListsAddedAndRemovedFamilies) {
  MadeStudy study;
  Session::enrol(*study, {.cohort = "surgeons"});
  study->amend(with(R"("id": "methods")", R"("id": "afterthought")"), "a thought");
  const auto history = analysisPlanHistory(*study);
  ASSERT_EQ(history.changes.size(), 2U);
  EXPECT_EQ(history.changes[0].family, "afterthought");
  EXPECT_EQ(history.changes[0].kind, FamilyChange::Kind::Added);
  EXPECT_EQ(history.changes[1].family, "methods");
  EXPECT_EQ(history.changes[1].kind, FamilyChange::Kind::Removed);
  EXPECT_FALSE(history.isDeclared("afterthought"));
}

TEST(AnalysisPlanHistory, IgnoresTitlesAndTheOrderOfComparisons) {
  protocols::Family one{.title = "One", .blocks = {}, .comparisons = {{"a", "b"}, {"a", "c"}}};
  auto other = one;
  other.title = "Another";
  other.comparisons = {{"c", "a"}, {"a", "b"}};
  EXPECT_TRUE(differingKeys(one, other).empty());
  other.comparisons.push_back({"b", "c"});
  EXPECT_EQ(differingKeys(one, other), std::vector<std::string_view>{"comparisons"});
}

TEST(AnalysisPlanHistory, NeedsAReasonForEveryVersionAfterTheFirstParticipant) {
  MadeStudy study;
  Session::enrol(*study, {.cohort = "surgeons"});
  study->amend(stricter(), "a reviewer asked");
  try {
    study->amend(tests::protocolFrom(tests::shortProtocol()), "");
    FAIL() << "nobody has begun with the last version, but somebody with an earlier one";
  } catch (const storage::StorageError& error) {
    EXPECT_TRUE(std::string(error.what()).starts_with("A participant has begun. ")) << error.what();
  }
}

}  // namespace plan_history_test
}  // namespace study
