#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/session/session.h"
#include "study/storage/hasher.h"
#include "tests/study/made_study.h"
#include "tests/support/scratch_folder.h"

namespace tests {

/// One call of a scripted session.
struct ScriptedCall {
  std::string name;
  std::function<void(study::Study&, study::Session&)> run;
};

/// A session with all features: answers, changed and removed ones, a name, trials that finish and
/// fail, a pause, a note, a change of language. Each call that returns is acknowledged.
const std::vector<ScriptedCall>& scriptedCalls();

/// A study in which that session is about to begin, as files to be copied, and the tables' content
/// after each of its calls.
class ScriptedStudy {
 public:
  ScriptedStudy();

  /// A fresh copy; removes the last one.
  std::string copy();

  /// The hash of the tables' content about the session after @p calls calls.
  const study::storage::Hash& after(std::size_t calls) const { return after_.at(calls); }

 private:
  ScratchFolder scratch_;
  OwnStation station_{scratch_ / "station"};
  std::vector<study::storage::Hash> after_;
};

/// How far a session came before a call failed.
struct Outcome {
  std::size_t acknowledged = 0;
  bool isComplete = false;
  std::string error;  ///< in words
};

/// When a fault is armed.
enum class Arm { BeforeOpening, BeforeTheFirstCall };

/// Opens the study in @p folder and runs the scripted session until a call throws. @p arm arms the
/// fault.
Outcome runScript(const std::string& folder, Arm when, const std::function<void()>& arm);

/// Checks, without faults, everything that must hold after any failure: acknowledged calls are
/// stored, at most the failed one in addition, everything verifies, and the session can be
/// continued to its end. Empty if all of this holds.
std::string whatIsWrongAfter(
    const ScriptedStudy& study,
    const std::string& folder,
    const Outcome& outcome,
    bool goesOnToTheEnd);

}  // namespace tests
