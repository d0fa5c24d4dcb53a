#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "haptics/wire/fri_message.h"

/// From bytes to messages and back, without heap, exceptions or recursion that a sender controls.
namespace haptics::wire::fri {

/// Why a datagram is not taken. Of several reasons the first of this list counts, but among
/// JointCount, ElementCount and NotFinite the one that comes first in ascending order of fields.
enum class Refusal : std::uint8_t {
  None,
  TooLong,         ///< more than kLargestDatagram
  TooShort,        ///< 2.7: no room for length and CRC
  LengthMismatch,  ///< 2.7
  CrcMismatch,     ///< 2.7
  Malformed,       ///< no protobuf, or something that is required is missing
  WrongIdentifier,
  JointCount,    ///< not exactly 7 of them
  ElementCount,  ///< a force or wrench without exactly 6; more of anything than the message holds
  NotFinite,
  MissingIpoJointPosition  ///< in a commanding state, where the client has to mirror it
};

/// In words: "none", "too_long", … "missing_ipo_joint_position".
std::string_view nameOf(Refusal refusal) noexcept;

/// Reads one datagram. As protobuf does, it takes packed and unpacked, any order of fields, unknown
/// fields and groups (100 levels at most), and merges what comes twice; an unknown value of an
/// enumeration is as if not there. Only the frame of 2.7 and the number of a transformation's
/// elements (1.x: at most 12, 2.x: at most 7) depend on the version: a field that only another
/// version knows is read as well.
///
/// Neither sequence counters nor the values of finite numbers are judged.
/// @param[out] out left as it was unless the answer is Refusal::None
Refusal decode(
    std::span<const std::uint8_t> datagram, Version version, MonitoringMessage& out) noexcept;
Refusal decode(
    std::span<const std::uint8_t> datagram, Version version, CommandMessage& out) noexcept;

/// Writes one datagram: fields in ascending order, joints and drive states unpacked, vectors and
/// transformations packed, shortest numbers.
///
/// Leaves out what the version does not know: inputs and outputs before 1.14; poses, redundancy
/// and the mode CartesianPose before 2.5; commanded joint positions of monitoring since 2.5;
/// external force before 2.7; the end of message in 2.7. The identifier is written as it is, so a
/// test can also make what decode() refuses.
///
/// @return the number of bytes; 0 if they do not fit into @p out or kLargestDatagram, or if
/// something is not finite, no value of its enumeration, or more than its list, name or version
/// can hold. What is in @p out then is of no use.
std::size_t encode(
    const MonitoringMessage& message, Version version, std::span<std::uint8_t> out) noexcept;
std::size_t encode(
    const CommandMessage& message, Version version, std::span<std::uint8_t> out) noexcept;

}  // namespace haptics::wire::fri
