// What the tests of an erasure have in common.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "study/session/erasure.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/session/erased_study.h"
#include "tests/study/walk.h"

namespace study {
namespace erasure_test {

namespace fs = std::filesystem;
using storage::ErasureLevel;
using tests::filesWith;
using tests::problemsOf;

// What one participant leaves in every field. All begin alike, so that one search finds each.
inline const std::string kSentinel = "Sentinel-7411";
inline const std::string kName = kSentinel + " Beeblebrox";

inline std::string planted(const std::string& where) {
  return kSentinel + " in " + where;
}

/// Answers everything in a form with the sentinel, and goes on to the end.
inline void takePart(Study& study, Session& session, const std::string& name) {
  session.note(planted("a note"));
  tests::walkTo(session, StepKind::Form);
  int order = 0;
  for (const auto& item : session.items()) {
    auto answer = tests::answerTo(session, item, ++order);
    if (std::holds_alternative<std::string>(answer.response) && item.options.empty()) {
      answer.response = item.isIdentifying ? name : planted(item.id);
    }
    session.record(answer);
  }
  session.finishStep();
  session.pause(planted("a pause"));
  session.resumeAfterPause();
  tests::walkTo(session, StepKind::Trial);
  session.beginTrial();
  study.traces().add(session.visit(), 0, std::vector<storage::TraceSample>(500));
  session.abortTrial({.ending = TrialEnding::Stopped, .ticks = 500, .traceSamples = 500});
  session.repeatStep(planted("a repetition"));
  tests::walkToTheEnd(session);
}

/// A study in which P001 is to be erased and P002 stays. Both wrote something in every field.
class ErasureTest : public testing::Test {
 protected:
  void SetUp() override {
    {
      auto session = Session::enrol(*study_, {.cohort = "surgeons"});
      takePart(*study_, session, kName);
    }
    other_.emplace(Session::enrol(*study_, {.cohort = "surgeons"}));
    tests::walkTo(*other_, StepKind::Form);
    other_->record(tests::answerTo(*other_, other_->items().front()));
    other_.reset();
  }

  ErasureReport eraseThem(ErasureLevel level = ErasureLevel::All) {
    return erase(
        *study_, {.participant = "P001", .level = level, .reason = "asked for it by telephone"});
  }

  std::vector<std::string> filesWithSentinel() {
    study_.close();
    auto files = filesWith(study_.folder(), kSentinel);
    study_.reopen();
    return files;
  }

  storage::SessionRow row() { return study_->sessions().load(SessionId{1}); }

  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
  std::optional<Session> other_;
};

}  // namespace erasure_test
}  // namespace study
