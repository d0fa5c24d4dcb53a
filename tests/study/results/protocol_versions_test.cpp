// Answers to a version of the protocol that was changed afterwards.
#include "study/results/protocol_versions.h"

#include <algorithm>

#include <gtest/gtest.h>

#include "study/export/codebook.h"
#include "study/export/export_rows.h"
#include "study/results/pooled_results.h"
#include "study/results/results.h"
#include "tests/study/exported_rows.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace protocol_versions_test {

using Values = std::vector<double>;

/// A version of the questionnaire after each condition.
struct Form {
  int points = 7;
  int key = -1;
  std::string text = "The cuts felt artificial.";
};

protocols::LoadedProtocol version(const Form& form) {
  const auto items =
      R"({"id": "real", "type": "likert", "text": "The cuts felt real."},
         {"id": "odd", "type": "likert", "key": )" +
      std::to_string(form.key) + R"(, "text": ")" + form.text + R"("})";
  const auto instrument =
      R"({"$schema": "instrument-1.schema.json", "id": "feel", "version": "1", "title": "Feel",
          "source": {"citation": "Own wording.", "licence": "CC0-1.0"}, "languages": ["en"],
          "scale": {"points": )" +
      std::to_string(form.points) + R"(, "low_label": "disagree", "high_label": "agree"},
          "items": [)" +
      items + R"(], "scores": [{"id": "total", "title": "Total", "items": ["real", "odd"],
                               "aggregate": "mean"}]})";
  return tests::protocolFrom(
      tests::shortProtocol(
          {.questionnaire = "feel", .files = "\"feel.json\"", .hasPreference = false}),
      {{"feel.json", instrument}});
}

class ProtocolVersionsTest : public testing::Test {
 protected:
  /// A participant who gives both answers to every form.
  void takePart(std::int64_t real, std::int64_t odd) {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    while (!session.isOver()) {
      if (session.step().kind != StepKind::Questionnaire) {
        tests::passStep(session);
        continue;
      }
      for (const auto& item : session.items()) {
        auto answer = tests::answerTo(session, item);
        answer.response = item.id == "real" ? real : odd;
        session.record(answer);
      }
      session.finishStep();
    }
  }

  Results results() { return computeResults(*study_, RunMode::Live); }

  static const CohortResult& surgeonsIn(const Results& results) {
    return results.families.at(0).cohorts.at(0);
  }

  /// The compared values of the first method, in ascending order.
  static Values comparedIn(const Results& results) {
    Values all;
    for (const auto& one : surgeonsIn(results).table.answers) {
      if (one.method == 0) all.push_back(one.score);
    }
    std::ranges::sort(all);
    return all;
  }

  static std::vector<std::string_view> flagsIn(const Results& results) {
    std::vector<std::string_view> ids;
    for (const auto& flag : surgeonsIn(results).flags) ids.push_back(flag.id);
    return ids;
  }

  static bool hasFlag(const Results& results, std::string_view id) {
    return std::ranges::count(flagsIn(results), id) > 0;
  }

  /// The changes as English sentences.
  static std::string changesIn(const Results& results) { return base::describe(results.changes); }

  /// The values of an item about the first condition in the table of items.
  static Values valuesOf(const Results& results, const std::string& item) {
    for (const auto& one : results.answers.items) {
      if (one.item == item) return one.values;
    }
    return {};
  }

  static Values scoresIn(const Results& results) {
    return results.instruments.at(0).scores.at(0).values;
  }

  tests::MadeStudy study_{version({})};
};

TEST_F(ProtocolVersionsTest, ReadEveryAnswerByTheKeyOfItsOwnSession) {
  takePart(6, 2);  // odd counts 8 − 2
  study_->amend(version({.key = 1}), "typo");
  EXPECT_EQ(comparedIn(results()), (Values{6, 6})) << "nobody has answered since";
  takePart(6, 3);
  const auto found = results();
  EXPECT_EQ(comparedIn(found), (Values{3, 6, 6, 6}));
  EXPECT_EQ(scoresIn(found), (Values{6, 4.5}));
  EXPECT_EQ(valuesOf(found, "odd"), (Values{2, 3})) << "as given";
  EXPECT_EQ(changesIn(found), "1 of 2 participants answered with another key: odd");
  EXPECT_TRUE(hasFlag(found, "answered_otherwise"));
  EXPECT_EQ(
      pooledResults(*study_, RunMode::Live).families[0].cohorts[0].conditions[0].answers.mean(),
      surgeonsIn(found).conditions[0].answers.mean());
}

TEST_F(ProtocolVersionsTest, PoolNoAnswersOfAnotherScale) {
  takePart(4, 2);
  takePart(7, 1);
  study_->amend(version({.points = 5}), "typo");
  takePart(5, 1);
  const auto found = results();
  EXPECT_EQ(comparedIn(found), (Values{5, 5}));
  EXPECT_EQ(surgeonsIn(found).table.participants.size(), 1U);
  EXPECT_EQ(scoresIn(found), (Values{5}));
  EXPECT_EQ(valuesOf(found, "real"), (Values{5}));
  EXPECT_TRUE(hasFlag(found, "other_scale"));
  EXPECT_FALSE(hasFlag(found, "missing_cells")) << "nobody left anything out";
  EXPECT_EQ(
      changesIn(found),
      "2 of 3 participants left out, who answered on another scale: odd, real, total");
  EXPECT_EQ(
      pooledResults(*study_, RunMode::Live).families[0].cohorts[0].conditions[0].answers.total(),
      2U);
}

TEST_F(ProtocolVersionsTest, ExportAnswersOfAnotherScaleWithTheQuestionThatTheyAnswer) {
  takePart(7, 1);
  const auto before = tests::rowsOf(itemsTable(*study_, {}));
  study_->amend(version({.points = 5}), "typo");
  takePart(5, 1);
  std::map<std::string_view, int> excluded;
  const StudyRows rows(*study_, {.isBlinded = false});
  for (const auto& answer : rows.answers()) {
    if (answer.instrument->id == "feel") ++excluded[answer.excluded];
  }
  EXPECT_EQ(excluded, (std::map<std::string_view, int>{{"", 6}, {"other_scale", 6}}));
  std::map<std::string, std::set<std::string>> highest;  // by the hash of the protocol
  for (const auto& row : tests::rowsOf(itemsTable(*study_, {}))) {
    if (row.at("item_id") == "odd") highest[row.at("protocol_hash")].insert(row.at("highest"));
  }
  const auto hashOf = [&](int version) {
    return study_->protocols().load(ProtocolId{version}).sha256;
  };
  EXPECT_EQ(
      highest,
      (std::map<std::string, std::set<std::string>>{{hashOf(1), {"7"}}, {hashOf(2), {"5"}}}));
  EXPECT_FALSE(before.at(0).contains("protocol_hash")) << "all answers are to one version";
}

TEST_F(ProtocolVersionsTest, SayThatWordsWereChanged) {
  takePart(6, 2);
  EXPECT_EQ(changesIn(results()), "");
  const auto other = version({.text = "I liked the room."});
  EXPECT_EQ(base::describe(changesBy(*study_, other)), "1 of 1 participants read other words: odd");
  study_->amend(other, "typo");
  takePart(6, 2);
  EXPECT_EQ(changesIn(results()), "1 of 2 participants read other words: odd");
  EXPECT_TRUE(hasFlag(results(), "answered_otherwise"));
}

TEST_F(ProtocolVersionsTest, SayThatAConditionWasChanged) {
  takePart(6, 2);
  const auto changedTo = [&](const std::string& part, const std::string& other) {
    const auto now = version({});
    auto text = now.text;
    text.replace(text.find(part), part.size(), other);
    return base::describe(changesBy(*study_, tests::protocolFrom(text, now.files)));
  };
  EXPECT_EQ(
      changedTo(R"("yield_force_n": 7.0)", R"("yield_force_n": 6.0)"),
      "1 of 1 participants felt another rendering: finite-elements");
  EXPECT_EQ(
      changedTo(R"("max_force_n": 8.0)", R"("max_force_n": 5.0)"),
      "1 of 1 participants felt another rendering: finite-elements, interpolation, kalman");
  EXPECT_EQ(
      changedTo("The title of kalman", "Another"),
      "1 of 1 participants felt this under another title: kalman");
  EXPECT_EQ(
      changedTo("balancedLatinSquare", "latinSquare"),
      "1 of 1 participants had orders of another design, and places began again at 1: felt");
  EXPECT_EQ(changedTo(R"("alpha": 0.05)", R"("alpha": 0.01)"), "") << "no answer is read by it";
}

TEST_F(ProtocolVersionsTest, AreAlikeWhereNothingMeansSomethingElse) {
  takePart(6, 2);
  auto other = version({});
  study_->amend(tests::protocolFrom(other.text + "\n", other.files), "a new line");
  takePart(6, 2);
  EXPECT_EQ(changesIn(results()), "");
  EXPECT_FALSE(hasFlag(results(), "answered_otherwise"));
}

}  // namespace protocol_versions_test
}  // namespace study
