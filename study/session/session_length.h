#pragma once

#include <cstddef>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/model/session_plan.h"

namespace study {

/// How fast participants are assumed to be.
struct Pace {
  double perItem = 8.0;          ///< to answer a statement or a choice [s]
  double perText = 40.0;         ///< to answer in free text [s]
  double perCut = 8.0;           ///< one cut or stroke [s]
  double perPreparation = 20.0;  ///< to prepare the next trial [s]
  double wordsPerSecond = 3.0;   ///< when reading a text
};

/// The steps of one kind, summed.
struct PartOfSession {
  StepKind kind = StepKind::Reading;
  std::size_t steps = 0;
  std::size_t items = 0;
  int cuts = 0;
  double seconds = 0.0;
  double secondsOnDevice = 0.0;  ///< part of seconds in which trials run on the device
};

/// The expected duration of a session and of its parts.
struct SessionLength {
  std::vector<PartOfSession> parts;  ///< in the order in which they first occur
  double seconds = 0.0;
  double secondsOnDevice = 0.0;  ///< part of seconds in which trials run on the device
};

/// The expected duration of one step.
PartOfSession partOf(
    const protocols::LoadedProtocol& loaded, const Step& step, const Pace& pace = {});

/// The expected duration of a session, which is the same for every participant. A trial is assumed
/// to have its minimum number of cuts, or one cut if the protocol gives no minimum.
SessionLength lengthOf(const protocols::LoadedProtocol& loaded, const Pace& pace);

/// Whole minutes, rounded up, as people are told the length of a session.
int minutesOf(double seconds);

}  // namespace study
