#pragma once

#include <cstddef>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/model/session_plan.h"

namespace study {

/// How fast participants are assumed to be.
struct Pace {
  double perItem = 8.0;         ///< to answer a statement or a choice [s]
  double perText = 40.0;        ///< to answer in free text [s]
  double perCut = 8.0;          ///< one cut or stroke [s]
  double perChange = 20.0;      ///< to change from one trial to the next [s]
  double wordsPerSecond = 3.0;  ///< when reading a text
};

/// All steps of one kind.
struct PartOfSession {
  StepKind kind = StepKind::Reading;
  std::size_t steps = 0;
  std::size_t items = 0;
  int cuts = 0;
  double seconds = 0.0;
  double secondsOfForce = 0.0;  ///< of these, in trials on the device
};

/// The expected duration of a session and of its parts.
struct SessionLength {
  std::vector<PartOfSession> parts;  ///< in the order in which they first occur
  double seconds = 0.0;
  double secondsOfForce = 0.0;  ///< of these, in trials on the device
};

/// One step of a session.
PartOfSession partOf(
    const protocols::LoadedProtocol& loaded, const Step& step, const Pace& pace = {});

/// The sum over all steps of a session, which is the same for every participant. A trial is taken
/// to last for its minimum number of cuts, or for one cut if the protocol names none.
SessionLength lengthOf(const protocols::LoadedProtocol& loaded, const Pace& pace);

}  // namespace study
