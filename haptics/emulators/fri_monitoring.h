#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "haptics/emulators/fri_answers.h"
#include "haptics/emulators/fri_arm.h"
#include "haptics/emulators/fri_session.h"
#include "haptics/emulators/impairment.h"
#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// What a controller has done and heard so far.
struct FriReport {
  FriSession::State state = FriSession::State::Idle;
  wire::fri::ConnectionQuality quality = wire::fri::ConnectionQuality::Poor;  ///< as told
  ConnectionQuality::Measures connection;
  FriEndReason lastEnd = FriEndReason::None;
  int endJoint = 0;        ///< 1 to 7; 0: none in particular
  std::int64_t endAt = 0;  ///< when the last motion ended [ns of the clock]; 0: none has
  bool hasOverlay = false;
  double force = 0.0;       ///< of the overlay along the reaming axis [N]
  double torque = 0.0;      ///< of the overlay about the reaming axis, right-handed [N·m]
  double travel = 0.0;      ///< along the reaming axis [m]
  double turn = 0.0;        ///< about it, right-handed [rad]
  std::int64_t zeroAt = 0;  ///< when the overlay last became nothing [ns of the clock]; 0: never
  std::uint64_t periods = 0;
  std::uint64_t messages = 0;   ///< made, sent or not
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

/// The content of a monitoring message that the arm does not measure.
struct FriLinkFields {
  std::uint32_t sequence = 0;
  std::uint32_t reflected = 0;
  wire::fri::ConnectionQuality quality = wire::fri::ConnectionQuality::Poor;
  std::uint32_t sendPeriod = 1;  ///< [ms]
  std::uint32_t receiveMultiplier = 1;
};

/// The message of this period, with the fields of all versions; the codec leaves out those that the
/// present version does not have. There are always 7 joints; the interpolator's position is set in
/// the commanding states only.
wire::fri::MonitoringMessage monitoringMessage(
    const FriLinkFields& standing, const FriSession& session, const FriArm& arm) noexcept;

/// Makes the seventh measured joint position of an encoded message an unknown field, so
/// that six are left, without a change of length; or makes the first no number. The CRC of 2.7 is
/// made right again: only a client that counts joints and looks at numbers can see it.
/// @param version  that the message is framed for
/// @return false, and nothing has changed, if there are no such joints.
bool leaveOutJoint(std::span<std::uint8_t> datagram, wire::fri::Version version) noexcept;
bool makeNotANumber(std::span<std::uint8_t> datagram, wire::fri::Version version) noexcept;

}  // namespace haptics::emulators
