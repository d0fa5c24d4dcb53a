#pragma once

#include <functional>
#include <string>
#include <vector>

#include "study/session/session.h"
#include "study/storage/hasher.h"
#include "tests/support/scratch_folder.h"

namespace tests {

/// What one call of a scripted session does.
struct ScriptedCall {
  std::string name;
  std::function<void(study::Study&, study::Session&)> run;
};

/// A session with everything in it: answers, changed and taken back, a name, trials that end well
/// and badly, a pause, a note, another language. Each call that returns has been acknowledged.
const std::vector<ScriptedCall>& scriptedCalls();

/// A study in which that session is about to begin, as files to be copied, and what the tables say
/// after each of its calls.
class ScriptedStudy {
 public:
  ScriptedStudy();

  /// A fresh copy; the last one is gone.
  std::string copy();

  /// What the tables say of the session after @p calls of them.
  const study::storage::Hash& after(std::size_t calls) const { return after_.at(calls); }

 private:
  ScratchFolder scratch_;
  std::vector<study::storage::Hash> after_;
};

/// How far a session came before something failed.
struct Outcome {
  std::size_t acknowledged = 0;
  bool isComplete = false;
  std::string error;  ///< in words
};

/// Opens the study in @p folder and runs the scripted session until a call throws. With @p arm
/// something is made to fail: before the study is opened, or when the session is about to begin.
enum class Arm { BeforeOpening, BeforeTheFirstCall };
Outcome runScript(const std::string& folder, Arm when, const std::function<void()>& arm);

/// Everything that must hold after whatever happened, nothing failing any more: what was
/// acknowledged is there, at most the call that was not is there as well, everything verifies, and
/// the session goes on to its end. Empty where it holds.
std::string whatIsWrongAfter(
    const ScriptedStudy& study,
    const std::string& folder,
    const Outcome& outcome,
    bool goesOnToTheEnd);

}  // namespace tests
