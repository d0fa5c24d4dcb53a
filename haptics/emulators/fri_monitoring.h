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

/// State and counts of an emulated controller.
struct FriReport {
  FriSession::State state = FriSession::State::Idle;
  /// The quality that is sent to the client.
  wire::fri::ConnectionQuality quality = wire::fri::ConnectionQuality::Poor;
  ConnectionQuality::Measures connection;
  FriEndReason lastEnd = FriEndReason::None;
  int endJoint = 0;        ///< 1 to 7; 0: no particular joint
  std::int64_t endAt = 0;  ///< time at which the last motion ended [ns of the clock]; 0: never
  bool hasOverlay = false;
  double force = 0.0;   ///< of the overlay along the reaming axis [N]
  double torque = 0.0;  ///< of the overlay about the reaming axis, right-handed [N·m]
  double travel = 0.0;  ///< along the reaming axis [m]
  double turn = 0.0;    ///< about the reaming axis, right-handed [rad]
  std::int64_t overlayZeroAt =
      0;  ///< time at which the overlay last became 0 [ns of the clock]; 0: never
  std::uint64_t periods = 0;
  std::uint64_t messages = 0;   ///< messages made, whether sent or not
  std::uint64_t datagrams = 0;  ///< sent, including garbage and duplicates, without the impostor's
  std::uint64_t unsent = 0;     ///< datagrams that the system did not accept
  FriAnswerMatcher::Counts answers;
  InjectedCounts injected;
  std::uint64_t sixJoints = 0;     ///< messages with six joints
  std::uint64_t notANumber = 0;    ///< messages in which a joint is NaN
  std::uint64_t wrongVersion = 0;  ///< messages framed as another version
  std::uint64_t stalled = 0;    ///< periods in which nothing was sent because of an ordered stall
  std::uint64_t impostors = 0;  ///< datagrams sent by the impostor
  std::uint64_t impostorAnswers = 0;  ///< answers that the client sent to the impostor
  std::uint64_t latePeriods = 0;      ///< periods that run() began late by a period or more
};

/// The report as one line of key=value pairs; the reason of the last end comes last, in quotes.
std::string statusOf(const FriReport& report);

/// The fields of a monitoring message that describe the connection.
struct FriLinkFields {
  std::uint32_t sequence = 0;   ///< counter of this message
  std::uint32_t reflected = 0;  ///< the client's last counter, sent back to it
  wire::fri::ConnectionQuality quality = wire::fri::ConnectionQuality::Poor;
  std::uint32_t sendPeriod = 1;  ///< [ms]
  std::uint32_t receiveMultiplier = 1;
};

/// The message of this period, with the fields of all versions; the codec leaves out the fields
/// that a version lacks. There are always 7 joints. The interpolator's position is set only in the
/// commanding states.
wire::fri::MonitoringMessage monitoringMessage(
    const FriLinkFields& link, const FriSession& session, const FriArm& arm) noexcept;

/// leaveOutJoint() turns the seventh measured joint position of an encoded message into an unknown
/// field; six are left, and the length does not change. setFirstJointToNaN() sets the first
/// position to NaN. Both correct the CRC of version 2.7. So only a client that checks the number
/// of joints and their values can notice the fault.
/// @param version  version whose frame the datagram has
/// @return false, without a change, if the message has no such joints.
bool leaveOutJoint(std::span<std::uint8_t> datagram, wire::fri::Version version) noexcept;
bool setFirstJointToNaN(std::span<std::uint8_t> datagram, wire::fri::Version version) noexcept;

}  // namespace haptics::emulators
