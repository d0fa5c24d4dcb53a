#include "tests/study/storage/scripted_session.h"

#include <filesystem>

#include "study/model/storage_error.h"
#include "study/session/verification.h"
#include "study/storage/content_hash.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace tests {
namespace {

namespace fs = std::filesystem;
using study::Session;
using study::SessionId;
using study::Study;

constexpr SessionId kSession{1};
constexpr const char* kName = "A. Name";

void answer(Session& session, std::size_t index, std::int64_t point) {
  auto given = answerTo(session, session.items()[index], static_cast<int>(index) + 1);
  given.response = point;
  session.record(given);
}

void keepChunk(Study& study, Session& session, int number) {
  study.traces().add(session.visit(), number, std::vector<study::storage::TraceSample>(500));
}

study::TrialRecord recordOf(int samples, study::TrialEnding ending) {
  auto record = feltTrial();
  record.ending = ending;
  record.ticks = samples;
  record.traceSamples = samples;
  return record;
}

/// Continues a session to its end from any state.
void goOn(Session& session) {
  while (!session.isOver()) {
    if (session.state() == study::SessionState::Interrupted) {
      session.repeatStep("again");
    } else if (session.state() == study::SessionState::Paused) {
      session.resumeAfterPause();
    } else {
      passStep(session);
    }
  }
}

std::string problemsOf(Study& study) {
  std::string all;
  for (const auto& check : study::verify(study).checks) {
    for (const auto& problem : check.problems) all += check.what + ": " + problem + "\n";
  }
  return all;
}

}  // namespace

const std::vector<ScriptedCall>& scriptedCalls() {
  using study::TrialEnding;
  static const std::vector<ScriptedCall> kCalls{
      {"consent", [](Study&, Session& s) { s.record(answerTo(s, s.items()[0], 1)); }},
      {"sign",
       [](Study&, Session& s) {
         auto given = answerTo(s, s.items()[2], 3);
         given.response = std::string(kName);
         s.record(given);
       }},
      {"give consent", [](Study&, Session& s) { s.finishStep(); }},
      {"begin", [](Study&, Session& s) { s.beginTrial(); }},
      {"keep a chunk", [](Study& study, Session& s) { keepChunk(study, s, 0); }},
      {"keep another", [](Study& study, Session& s) { keepChunk(study, s, 1); }},
      {"finish", [](Study&, Session& s) { s.finishTrial(recordOf(1000, TrialEnding::Finished)); }},
      {"answer", [](Study&, Session& s) { answer(s, 0, 2); }},
      {"change it", [](Study&, Session& s) { answer(s, 0, 5); }},
      {"answer more", [](Study&, Session& s) { answer(s, 1, 1); }},
      {"take it back", [](Study&, Session& s) { s.retract(s.items()[1].id); }},
      {"another language", [](Study&, Session& s) { s.setLanguage("de"); }},
      {"note", [](Study&, Session& s) { s.note("the lamp flickers"); }},
      {"pause", [](Study&, Session& s) { s.pause("coffee"); }},
      {"go on", [](Study&, Session& s) { s.resumeAfterPause(); }},
      {"feel it again", [](Study&, Session& s) { s.repeatStep("forgot how it was"); }},
      {"begin again", [](Study&, Session& s) { s.beginTrial(); }},
      {"break off", [](Study&, Session& s) { s.abortTrial(recordOf(0, TrialEnding::DeviceGone)); }},
      {"skip", [](Study&, Session& s) { s.skipStep("no device"); }},
      {"begin the next", [](Study&, Session& s) { s.beginTrial(); }},
      {"leave", [](Study&, Session& s) { s.withdraw("tired"); }},
  };
  return kCalls;
}

ScriptedStudy::ScriptedStudy() {
  const auto protocol = protocolFrom(shortProtocol({.labels = "position"}));
  study::SimulatedClock clock;
  const std::string original = scratch_ / "original";
  {
    auto study = Study::create(original, protocol, clock, 3, tests::knownSecret());
    Session::enrol(study, {.cohort = "surgeons"});
  }
  fs::remove(original + "/ballast");  // reserved again when a copy is opened
  const std::string folder = copy();
  auto study = Study::open(folder, clock);
  auto session = Session::resume(study, kSession);
  after_.push_back(contentHash(study.database(), kSession));
  for (const auto& call : scriptedCalls()) {
    clock.advance(1.0);
    call.run(study, session);
    after_.push_back(contentHash(study.database(), kSession));
  }
}

std::string ScriptedStudy::copy() {
  fs::remove_all(scratch_ / "copy");
  fs::copy(scratch_ / "original", scratch_ / "copy", fs::copy_options::recursive);
  // Every copy goes on by itself: one station would take them for branches of one study.
  forgetWhatWasSigned();
  return scratch_ / "copy";
}

Outcome runScript(const std::string& folder, Arm when, const std::function<void()>& arm) {
  Outcome outcome;
  try {
    study::SimulatedClock clock;
    if (when == Arm::BeforeOpening) arm();
    auto study = Study::open(folder, clock);
    auto session = Session::resume(study, kSession);
    if (when == Arm::BeforeTheFirstCall) arm();
    for (const auto& call : scriptedCalls()) {
      clock.advance(1.0);
      call.run(study, session);
      ++outcome.acknowledged;
    }
    outcome.isComplete = true;
  } catch (const study::storage::StorageError& error) {
    outcome.error = error.what();
  }
  return outcome;
}

std::string whatIsWrongAfter(
    const ScriptedStudy& scripted,
    const std::string& folder,
    const Outcome& outcome,
    bool goesOnToTheEnd) {
  const std::string where =
      " after " + std::to_string(outcome.acknowledged) + " calls (" + outcome.error + ")\n";
  if (!outcome.isComplete && outcome.error.size() < 20) return "no words" + where;
  study::SimulatedClock clock;
  auto study = Study::open(folder, clock);
  const auto found = contentHash(study.database(), kSession);
  const bool isThere = found == scripted.after(outcome.acknowledged);
  const bool isMore = !outcome.isComplete && found == scripted.after(outcome.acknowledged + 1);
  if (!isThere && !isMore) return "what was acknowledged is not what is there" + where;
  if (outcome.acknowledged > 1 && !study.identities().has({"P001", 1, 0, 1}, "signature")) {
    return "the name is lost" + where;
  }
  if (const auto problems = problemsOf(study); !problems.empty()) return problems + where;
  if (!goesOnToTheEnd) return {};
  auto session = Session::resume(study, kSession);
  goOn(session);
  const auto problems = problemsOf(study);
  return problems.empty() ? std::string() : "at the end: " + problems + where;
}

}  // namespace tests
