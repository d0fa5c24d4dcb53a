#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <type_traits>

#include "haptics/wire/crc32.h"
#include "haptics/wire/fri_codec.h"
#include "haptics/wire/fri_fields.h"
#include "haptics/wire/protobuf_reader.h"

namespace haptics::wire::fri {
namespace {

/// A map from a few addresses (of messages and fields) to numbers, 0 by default: facts about a
/// message that are not stored in it.
class AddressMap {
 public:
  std::uint32_t& operator[](const void* place) noexcept {
    const auto row = std::find(places_.begin(), places_.begin() + count_, place);
    const auto index = static_cast<std::size_t>(row - places_.begin());
    if (row == places_.begin() + count_ && index + 1 < places_.size()) places_[count_++] = place;
    return values_[index];
  }

  std::uint32_t at(const void* place) const noexcept {
    const auto row = std::find(places_.begin(), places_.begin() + count_, place);
    return row == places_.begin() + count_
               ? 0
               : values_[static_cast<std::size_t>(row - places_.begin())];
  }

 private:
  // Enough for a monitoring message: 29 submessages with required fields, and 7 fields of joints or
  // vectors.
  std::array<const void*, 40> places_{};
  std::array<std::uint32_t, 40> values_{};
  std::uint8_t count_ = 0;
};

/// Collects the required fields of a message: bit n is set if field n is a required number,
/// enumeration or name. Required submessages need no bit, since their own required fields would be
/// missing, too.
class RequiredFields {
 public:
  template <typename T>
  void operator()(std::uint32_t number, const T& /*value*/, Versions /*versions*/) noexcept {
    constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_enum_v<T> || Is<T, Name>;
    if (kIsPlain) bits_ |= 1U << number;
  }

  std::uint32_t requiredFieldBits() const noexcept { return bits_; }

 private:
  std::uint32_t bits_ = 0;
};

std::uint32_t requiredFieldBitsOf(const Message auto& message) noexcept {
  RequiredFields required;
  visit(message, required);
  return required.requiredFieldBits();
}

/// Facts about a message that was read, for its validation.
struct Findings {
  AddressMap presentFields;  ///< for each message, its required fields that were present, as bits
  AddressMap counts;         ///< for joints and vectors, their number of elements
  bool hasTooManyElements = false;
};

/// Checks a message that was read. It goes through the fields in ascending order, so that the first
/// refusal it finds is that of the lowest field.
class Validator {
 public:
  Validator(const Findings& findings, Version version) noexcept
      : findings_(findings), version_(version) {}

  template <typename T>
  void operator()(std::uint32_t /*number*/, const T& value, Versions /*versions*/) noexcept {
    validate(value);
  }

  template <Message T>
  void validate(const T& message) noexcept {
    const std::uint32_t required = requiredFieldBitsOf(message);
    if (required != 0 && (required & ~findings_.presentFields.at(&message)) != 0)
      isIncomplete_ = true;
    visit(message, *this);
  }

  /// Whether a required field is missing.
  bool isIncomplete() const noexcept { return isIncomplete_; }
  Refusal first() const noexcept { return first_; }

 private:
  template <typename T>
  void validate(const std::optional<T>& value) noexcept {
    if (value) validate(*value);
  }

  template <typename T>
  void validate(const T& /*value*/) noexcept requires(Number<T> || Choice<T>) {}
  void validate(const Name& /*value*/) noexcept {}
  void validate(double value) noexcept { expect(std::isfinite(value), Refusal::NotFinite); }

  void validate(const Joints& joints) noexcept { validateArray(joints, Refusal::JointCount); }
  void validate(const Vector6& vector) noexcept { validateArray(vector, Refusal::ElementCount); }

  template <std::size_t N>
  void validateArray(const std::array<double, N>& values, Refusal ifOtherCount) noexcept {
    expect(findings_.counts.at(&values) == N, ifOtherCount);
    for (const double value : values) validate(value);
  }

  void validate(const BoundedArray<double, 12>& elements) noexcept {
    expect(elements.count <= mostElements(version_), Refusal::ElementCount);
    for (const double element : elements) validate(element);
  }

  template <typename T, std::size_t N>
  void validate(const BoundedArray<T, N>& list) noexcept {
    for (const T& item : list) validate(item);
  }

  void expect(bool isTrue, Refusal otherwise) noexcept {
    if (!isTrue && first_ == Refusal::None) first_ = otherwise;
  }

  const Findings& findings_;
  Version version_;
  bool isIncomplete_ = false;
  Refusal first_ = Refusal::None;
};

bool read(Reader in, Message auto& message, Findings& findings) noexcept;

/// Visits a message and decodes the field with the tag's number.
class FieldReader {
 public:
  FieldReader(Reader& in, Tag tag, Findings& findings) noexcept
      : in_(in), tag_(tag), findings_(findings) {}

  template <typename T>
  void operator()(std::uint32_t number, T& value, Versions /*versions*/) noexcept {
    if (number == tag_.number) isTaken_ = take(value);
  }

  bool isTaken() const noexcept { return isTaken_; }
  /// False if the value is unknown in its enumeration, which protobuf ignores.
  bool hasValue() const noexcept { return hasValue_; }

 private:
  bool is(Wire wire) const noexcept { return tag_.wire == wire; }

  template <typename T>
  bool take(std::optional<T>& value) noexcept {
    const bool wasThere = value.has_value();
    if (!wasThere) value.emplace();
    const bool wasTaken = take(*value);
    if (!wasThere && !hasValue_) value.reset();
    return wasTaken;
  }

  template <Number T>
  bool take(T& value) noexcept {
    if (!is(Varint)) return false;
    value = static_cast<T>(in_.varint());
    return hasValue_ = true;
  }

  bool take(double& value) noexcept {
    if (!is(Fixed64)) return false;
    value = in_.number();
    return hasValue_ = true;
  }

  template <Choice T>
  bool take(T& value) noexcept {
    if (!is(Varint)) return false;
    const std::optional<T> chosen = choice<T>(in_);
    if (chosen) value = *chosen;
    hasValue_ = chosen.has_value();
    return true;
  }

  bool take(Name& name) noexcept {
    if (!is(Delimited)) return false;
    const std::span<const std::uint8_t> bytes = in_.delimited();
    if (bytes.size() > name.bytes.size()) findings_.hasTooManyElements = true;
    name = Name{};
    name.size = std::min(bytes.size(), name.bytes.size());
    std::copy_n(bytes.begin(), name.size, name.bytes.begin());
    return hasValue_ = true;
  }

  bool take(Joints& joints) noexcept { return takeArray(joints); }
  bool take(Vector6& vector) noexcept { return takeArray(vector); }
  bool take(BoundedArray<double, 12>& elements) noexcept {
    return takeNumbers(in_, tag_, [&](double value) { append(elements, value); });
  }

  bool take(BoundedArray<DriveState, 7>& states) noexcept {
    if (is(Varint)) {
      takeDriveState(in_, states);
      return true;
    }
    if (!is(Delimited)) return false;
    Reader inside = in_.nested();
    while (inside.hasMore()) takeDriveState(inside, states);
    if (!inside.isSound()) in_.fail();
    return true;
  }

  template <Message T, std::size_t N>
  bool take(BoundedArray<T, N>& list) noexcept {
    if (!is(Delimited)) return false;
    T* const place = list.add();
    return place != nullptr ? take(*place) : takeSurplus<T>();
  }

  /// Decodes an element for which the list has no room, only to find out whether it is malformed.
  template <Message T>
  bool takeSurplus() noexcept {
    T surplus;
    Findings findings;
    Validator validator(findings, Version::V1_11);
    const bool isSound = read(in_.nested(), surplus, findings);
    validator.validate(surplus);
    if (!isSound || validator.isIncomplete()) in_.fail();
    findings_.hasTooManyElements = true;
    return true;
  }

  template <Message T>
  bool take(T& message) noexcept {
    if (!is(Delimited)) return false;
    if (!read(in_.nested(), message, findings_)) in_.fail();
    return hasValue_ = true;
  }

  /// Decodes joints or a vector, which are messages with one field, the numbers.
  template <std::size_t N>
  bool takeArray(std::array<double, N>& values) noexcept {
    if (!is(Delimited)) return false;
    std::uint32_t& count = findings_.counts[&values];
    const auto add = [&](double value) {
      if (count < N) values[count] = value;
      ++count;
    };
    Reader inside = in_.nested();
    while (inside.hasMore()) {
      const Tag tag = inside.tag();
      if (tag.number != 1 || !takeNumbers(inside, tag, add)) inside.skip(tag);
    }
    if (!inside.isSound()) in_.fail();
    return hasValue_ = true;
  }

  static bool takeNumbers(Reader& in, Tag tag, const auto& add) noexcept {
    if (tag.wire == Fixed64) {
      add(in.number());
      return true;
    }
    if (tag.wire != Delimited) return false;
    Reader inside = in.nested();
    while (inside.hasMore()) add(inside.number());
    if (!inside.isSound()) in.fail();
    return true;
  }

  void takeDriveState(Reader& in, BoundedArray<DriveState, 7>& states) noexcept {
    if (const std::optional<DriveState> state = choice<DriveState>(in)) append(states, *state);
  }

  template <typename T, std::size_t N>
  void append(BoundedArray<T, N>& list, T value) noexcept {
    if (T* const place = list.add()) {
      *place = value;
    } else {
      findings_.hasTooManyElements = true;
    }
  }

  /// A value of an enumeration; std::nullopt if it is unknown. Like protobuf it reads 32 bits.
  template <Choice T>
  static std::optional<T> choice(Reader& in) noexcept {
    const auto number = static_cast<std::uint32_t>(in.varint());
    if (!in.isSound() || number > 0xFF || !isKnown(static_cast<T>(number))) return std::nullopt;
    return static_cast<T>(number);
  }

  Reader& in_;
  Tag tag_;
  Findings& findings_;
  bool isTaken_ = false;
  bool hasValue_ = false;
};

bool read(Reader in, Message auto& message, Findings& findings) noexcept {
  std::uint32_t presentFields = 0;
  while (in.hasMore()) {
    const Tag tag = in.tag();
    FieldReader field(in, tag, findings);
    visit(message, field);
    if (!field.isTaken()) in.skip(tag);
    if (field.hasValue()) presentFields |= 1U << tag.number;
  }
  if (requiredFieldBitsOf(message) != 0) findings.presentFields[&message] |= presentFields;
  return in.isSound();
}

Refusal validateState(const MonitoringMessage& message) noexcept {
  const bool isCommanding =
      message.connection && message.connection->state >= SessionState::CommandingWait;
  const bool hasPosition = message.ipoData && message.ipoData->jointPosition;
  return isCommanding && !hasPosition ? Refusal::MissingIpoJointPosition : Refusal::None;
}

Refusal validateState(const CommandMessage& /*message*/) noexcept {
  return Refusal::None;
}

template <typename T>
Refusal readMessage(std::span<const std::uint8_t> bytes, Version version, T& out) noexcept {
  const std::uint32_t identifier = T{}.header.identifier;  // identifier of this type of message
  T message;
  Findings findings;
  if (!read(Reader(bytes), message, findings)) return Refusal::Malformed;
  Validator validator(findings, version);
  validator.validate(message);
  if (validator.isIncomplete()) return Refusal::Malformed;
  if (message.header.identifier != identifier) return Refusal::WrongIdentifier;
  if (findings.hasTooManyElements) return Refusal::ElementCount;
  if (validator.first() != Refusal::None) return validator.first();
  const Refusal own = validateState(message);
  if (own == Refusal::None) out = message;
  return own;
}

/// Four bytes as a little-endian number.
std::uint32_t wordAt(const std::uint8_t* bytes) noexcept {
  std::uint32_t word = 0;
  for (unsigned i = 0; i < 4; ++i) word |= std::uint32_t{bytes[i]} << (8 * i);
  return word;
}

Refusal validateFrame(std::span<const std::uint8_t> datagram) noexcept {
  if (datagram.size() < kFrameSize) return Refusal::TooShort;
  const std::size_t inside = datagram.size() - kFrameSize;
  if (wordAt(datagram.data()) != inside) return Refusal::LengthMismatch;
  const std::uint8_t* const bytes = datagram.data() + kLengthSize;
  return crc32(bytes, inside) == wordAt(bytes + inside) ? Refusal::None : Refusal::CrcMismatch;
}

template <typename T>
Refusal decodeAny(std::span<const std::uint8_t> datagram, Version version, T& out) noexcept {
  if (datagram.size() > kLargestDatagram) return Refusal::TooLong;
  if (!isInVersions(version, kSince2_7)) return readMessage(datagram, version, out);
  const Refusal refusal = validateFrame(datagram);
  if (refusal != Refusal::None) return refusal;
  return readMessage(datagram.subspan(kLengthSize, datagram.size() - kFrameSize), version, out);
}

}  // namespace

std::string_view nameOf(Refusal refusal) noexcept {
  constexpr std::array<std::string_view, 11> kNames{
      "none",
      "too_long",
      "too_short",
      "length_mismatch",
      "crc_mismatch",
      "malformed",
      "wrong_identifier",
      "joint_count",
      "element_count",
      "not_finite",
      "missing_ipo_joint_position"};
  return kNames[static_cast<std::size_t>(refusal)];
}

Refusal decode(
    std::span<const std::uint8_t> datagram, Version version, MonitoringMessage& out) noexcept {
  return decodeAny(datagram, version, out);
}

Refusal decode(
    std::span<const std::uint8_t> datagram, Version version, CommandMessage& out) noexcept {
  return decodeAny(datagram, version, out);
}

}  // namespace haptics::wire::fri
