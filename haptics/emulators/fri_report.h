#pragma once

#include <cstdint>
#include <string>

#include "haptics/emulators/connection_quality.h"
#include "haptics/emulators/fri_answers.h"
#include "haptics/emulators/fri_session.h"
#include "haptics/emulators/impairment.h"
#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// What a controller has done and heard so far.
struct FriReport {
  FriSession::State state = FriSession::State::Idle;
  wire::fri::ConnectionQuality quality = wire::fri::ConnectionQuality::Poor;  ///< as told
  ConnectionQuality::Measures connection;
  FriEnd lastEnd = FriEnd::None;
  int endJoint = 0;        ///< 1 to 7; 0: none in particular
  std::int64_t endAt = 0;  ///< when the last motion ended [ns of the clock]; 0: none has
  bool hasOverlay = false;
  double force = 0.0;       ///< of the overlay along the reaming axis [N]
  double travel = 0.0;      ///< along the reaming axis [m]
  std::int64_t zeroAt = 0;  ///< when the overlay last became nothing [ns of the clock]; 0: never
  std::uint64_t periods = 0;
  std::uint64_t messages = 0;   ///< made, whatever became of them
  std::uint64_t datagrams = 0;  ///< that left, garbage and doubles with them, impostor's apart
  std::uint64_t unsent = 0;     ///< that the system did not take
  FriAnswers::Counts answers;
  Injected injected;
  std::uint64_t sixJoints = 0;
  std::uint64_t notANumber = 0;
  std::uint64_t wrongVersion = 0;
  std::uint64_t stalled = 0;      ///< periods in which nothing was sent on order
  std::uint64_t impostors = 0;    ///< datagrams from the other sender
  std::uint64_t misled = 0;       ///< answers that the other sender got
  std::uint64_t latePeriods = 0;  ///< run() was late by a period or more
};

/// In one line of key=value; the words of the last end come last, in quotes.
std::string statusOf(const FriReport& report);

}  // namespace haptics::emulators
