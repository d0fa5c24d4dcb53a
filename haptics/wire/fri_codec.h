#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>

#include "haptics/wire/fri_message.h"

/// Decodes and encodes FRI messages without heap, exceptions or recursion that a sender controls.
namespace haptics::wire::fri {

/// Why a datagram is refused. If there are several reasons, the first in this list is reported,
/// with two exceptions: a list or name for which there is no room (ElementCount) comes before
/// JointCount; and of all other JointCount, ElementCount and NotFinite that of the lowest field
/// number is reported.
enum class Refusal : std::uint8_t {
  None,
  TooLong,         ///< more than kLargestDatagram
  TooShort,        ///< 2.7: shorter than length and CRC
  LengthMismatch,  ///< 2.7
  CrcMismatch,     ///< 2.7
  Malformed,       ///< not protobuf, or a required field is missing
  WrongIdentifier,
  JointCount,    ///< a joint field without exactly 7 elements
  ElementCount,  ///< a force or wrench without exactly 6 elements; a list with too many; a name
                 ///< that is too long
  NotFinite,
  MissingIpoJointPosition  ///< in a commanding state, in which the client must mirror it
};

/// "none", "too_long", … "missing_ipo_joint_position".
std::string_view nameOf(Refusal refusal) noexcept;

/// Decodes one datagram. Like protobuf it accepts packed and unpacked numbers, any order of fields,
/// unknown fields and groups (at most 100 levels), merges fields that occur twice, and ignores
/// unknown values of an enumeration. Only the frame of 2.7 and the number of a transformation's
/// elements (1.x: at most 12, 2.x: at most 7) depend on the version; fields of other versions are
/// read as well.
///
/// Sequence counters and the values of finite numbers are not checked. @param[out] out unchanged
/// unless the result is Refusal::None
Refusal decode(
    std::span<const std::uint8_t> datagram, Version version, MonitoringMessage& out) noexcept;
Refusal decode(
    std::span<const std::uint8_t> datagram, Version version, CommandMessage& out) noexcept;

/// Encodes one datagram: fields in ascending order, joints and drive states unpacked, vectors and
/// transformations packed, varints as short as possible.
///
/// Omits what the version lacks: inputs and outputs before 1.14; poses, redundancy and the mode
/// CartesianPose before 2.5; commanded joint positions of monitoring since 2.5; external force
/// before 2.7; the end of message in 2.7. The identifier is not checked, so that a test can also
/// encode messages that decode() refuses.
///
/// @return the number of bytes; 0 if they do not fit into @p out or kLargestDatagram, or if a value
/// is not finite, not in its enumeration, or too long for its list, name or version. The content of
/// @p out is then undefined.
std::size_t encode(
    const MonitoringMessage& message, Version version, std::span<std::uint8_t> out) noexcept;
std::size_t encode(
    const CommandMessage& message, Version version, std::span<std::uint8_t> out) noexcept;

}  // namespace haptics::wire::fri
