// What a participant did not feel, because its trial was skipped.
#include <algorithm>
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "study/export/export_rows.h"
#include "study/results/results.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study {
namespace skipped_alternative_test {

class SkippedAlternativeTest : public testing::Test {
 protected:
  /// A participant who skips the second trial, and is now asked for a preference.
  Session atThePreference() {
    auto session = Session::enrol(*study_, {.cohort = "surgeons"});
    for (int trials = 0; session.step().kind != StepKind::Preference;) {
      if (session.step().kind == StepKind::Trial && ++trials == 2) {
        skipped_ = std::to_string(session.step().label);
        session.skipStep("it hurt");
      } else {
        tests::passStep(session);
      }
    }
    return session;
  }

  /// The answer that names an alternative.
  static GivenAnswer voteFor(const Session& session, const std::string& label) {
    for (const auto& item : session.items()) {
      if (item.optionSource != questionnaires::OptionSource::Alternatives) continue;
      auto vote = tests::answerTo(session, item);
      vote.response = label;
      return vote;
    }
    throw std::logic_error("no preference is asked");
  }

  tests::MadeStudy study_;
  std::string skipped_;
};

TEST_F(SkippedAlternativeTest, IsNotOffered) {
  auto session = atThePreference();
  const auto offered = session.alternatives();
  EXPECT_EQ(offered.size(), 2U);
  EXPECT_EQ(std::ranges::count(offered, skipped_), 0);
  EXPECT_THROW(session.record(voteFor(session, skipped_)), UserError);
  session.record(voteFor(session, offered.front()));
}

TEST_F(SkippedAlternativeTest, LeavesTheVoteOut) {
  auto session = atThePreference();
  tests::walkToTheEnd(session);
  auto other = Session::enrol(*study_, {.cohort = "surgeons"});
  tests::walkToTheEnd(other);
  const auto votes = computeResults(*study_, RunMode::Live).votes.at(0);
  EXPECT_EQ(votes.votes.total(), 1U);
  EXPECT_EQ(votes.leftOut, 1U);
  int leftOut = 0;
  for (const auto& row : StudyRows(*study_, {}).answers()) {
    leftOut += row.excluded == "not_all_felt" ? 1 : 0;
  }
  EXPECT_EQ(leftOut, 1);
}

}  // namespace skipped_alternative_test
}  // namespace study
