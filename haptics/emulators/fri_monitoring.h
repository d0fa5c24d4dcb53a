#pragma once

#include <cstdint>
#include <span>

#include "haptics/emulators/fri_arm.h"
#include "haptics/emulators/fri_session.h"
#include "haptics/wire/fri_message.h"

namespace haptics::emulators {

/// What a monitoring message tells besides what the arm measures.
struct FriStanding {
  std::uint32_t sequence = 0;
  std::uint32_t reflected = 0;
  wire::fri::ConnectionQuality quality = wire::fri::ConnectionQuality::Poor;
  std::uint32_t sendPeriod = 1;  ///< [ms]
  std::uint32_t receiveMultiplier = 1;
};

/// The message of this period, with everything that any version knows; the codec leaves out what
/// the version at hand does not. There are 7 joints, always; what the interpolator is at is there
/// in the commanding states only.
wire::fri::MonitoringMessage monitoringMessage(
    const FriStanding& standing, const FriSession& session, const FriArm& arm) noexcept;

/// Makes the seventh measured joint position of an encoded message a field that nobody knows, so
/// that six are left, without a change of length; or makes the first no number. The CRC of 2.7 is
/// made right again: only a client that counts joints and looks at numbers can see it.
/// @param version  that the message is framed for
/// @return false, and nothing has changed, if there are no such joints.
bool leaveOutJoint(std::span<std::uint8_t> datagram, wire::fri::Version version) noexcept;
bool makeNotANumber(std::span<std::uint8_t> datagram, wire::fri::Version version) noexcept;

}  // namespace haptics::emulators
