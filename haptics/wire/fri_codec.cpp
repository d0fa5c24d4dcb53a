#include "haptics/wire/fri_codec.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <concepts>
#include <cstring>
#include <optional>
#include <type_traits>

#include "haptics/wire/crc32.h"

namespace haptics::wire::fri {
namespace {

constexpr std::size_t kLengthSize = 4;  // of the frame of 2.7, as is the CRC's
constexpr std::size_t kFrameSize = 2 * kLengthSize;
constexpr std::size_t kDeepest = 100;  // what protobuf allows
constexpr std::size_t kShortVarint = 5;
constexpr std::size_t kLongVarint = 10;

// ---- what the messages are made of ----

/// The versions that know a field.
struct Known {
  Version since = Version::V1_11;
  Version until = Version::V2_7;
};
constexpr Known kEver{};
constexpr Known kIo{.since = Version::V1_14};
constexpr Known kOne{.until = Version::V1_16};
constexpr Known kTwo{.since = Version::V2_5};
constexpr Known kLast{.since = Version::V2_7};
constexpr Known kBeforeLast{.until = Version::V2_5};

constexpr bool knows(Version version, Known known) noexcept {
  return version >= known.since && version <= known.until;
}

constexpr std::size_t mostElements(Version version) noexcept {
  return knows(version, kTwo) ? 7 : 12;
}

template <typename T, typename Wanted>
concept Is = std::same_as<std::remove_const_t<T>, Wanted>;

// One table for reading, judging and writing: number and place of every field, in ascending order.
// What is neither optional nor a list is required.

void visit(Is<Header> auto& m, auto& field) noexcept {
  field(1, m.identifier, kEver);
  field(2, m.sequence, kEver);
  field(3, m.reflected, kEver);
}

void visit(Is<TimeStamp> auto& m, auto& field) noexcept {
  field(1, m.seconds, kEver);
  field(2, m.nanoseconds, kEver);
}

void visit(Is<Transformation> auto& m, auto& field) noexcept {
  field(1, m.name, kEver);
  field(2, m.elements, kEver);
  field(3, m.timestamp, kEver);
}

void visit(Is<IoValue> auto& m, auto& field) noexcept {
  field(1, m.name, kEver);
  field(2, m.type, kEver);
  field(3, m.direction, kEver);
  field(4, m.digital, kEver);
  field(5, m.analog, kEver);
}

void visit(Is<Redundancy> auto& m, auto& field) noexcept {
  field(1, m.strategy, kEver);
  field(2, m.value, kEver);
}

void visit(Is<ConnectionInfo> auto& m, auto& field) noexcept {
  field(1, m.state, kEver);
  field(2, m.quality, kEver);
  field(3, m.sendPeriod, kEver);
  field(4, m.receiveMultiplier, kEver);
}

void visit(Is<RobotInfo> auto& m, auto& field) noexcept {
  field(1, m.jointCount, kEver);
  field(2, m.safetyState, kEver);
  field(5, m.driveStates, kEver);
  field(6, m.operationMode, kEver);
  field(7, m.controlMode, kEver);
}

void visit(Is<MonitorData> auto& m, auto& field) noexcept {
  field(1, m.measuredPosition, kEver);
  field(2, m.measuredTorque, kEver);
  field(3, m.commandedPosition, kOne);
  field(4, m.commandedTorque, kEver);
  field(5, m.externalTorque, kEver);
  field(6, m.externalForce, kLast);
  field(8, m.inputs, kIo);
  field(9, m.pose, kTwo);
  field(10, m.redundancy, kTwo);
  field(15, m.timestamp, kEver);
}

void visit(Is<IpoData> auto& m, auto& field) noexcept {
  field(1, m.jointPosition, kEver);
  field(2, m.pose, kTwo);
  field(3, m.redundancy, kTwo);
  field(10, m.commandMode, kEver);
  field(11, m.overlay, kEver);
  field(12, m.trackingPerformance, kEver);
}

void visit(Is<CommandData> auto& m, auto& field) noexcept {
  field(1, m.jointPosition, kEver);
  field(2, m.wrench, kEver);
  field(3, m.jointTorque, kEver);
  field(4, m.transformations, kEver);
  field(5, m.outputs, kIo);
  field(6, m.pose, kTwo);
  field(7, m.redundancy, kTwo);
}

void visit(Is<EndOfMessage::Checksum> auto& m, auto& field) noexcept {
  field(1, m.crc32, kEver);
}

void visit(Is<EndOfMessage> auto& m, auto& field) noexcept {
  field(1, m.length, kEver);
  field(2, m.checksum, kEver);
}

void visit(Is<MonitoringMessage> auto& m, auto& field) noexcept {
  field(1, m.header, kEver);
  field(2, m.robotInfo, kEver);
  field(3, m.monitorData, kEver);
  field(4, m.connection, kEver);
  field(5, m.ipoData, kEver);
  field(6, m.requestedTransformations, kEver);
  field(15, m.endOfMessage, kBeforeLast);
}

void visit(Is<CommandMessage> auto& m, auto& field) noexcept {
  field(1, m.header, kEver);
  field(2, m.data, kEver);
  field(15, m.endOfMessage, kBeforeLast);
}

template <typename T>
concept Number = std::same_as<T, std::uint32_t> || std::same_as<T, std::int32_t> ||
    std::same_as<T, std::uint64_t>;
template <typename T>
concept Choice = std::is_enum_v<T>;
template <typename T>
concept Message = std::is_class_v<T>;  // joints, vectors, names and lists are better matches

constexpr bool isKnown(RedundancyStrategy value) noexcept {
  return value == RedundancyStrategy::E1 || value == RedundancyStrategy::None;
}

// The last value of every enumeration without gaps.
constexpr SessionState lastOf(SessionState) noexcept {
  return SessionState::CommandingActive;
}
constexpr ConnectionQuality lastOf(ConnectionQuality) noexcept {
  return ConnectionQuality::Excellent;
}
constexpr SafetyState lastOf(SafetyState) noexcept {
  return SafetyState::StopLevel2;
}
constexpr OperationMode lastOf(OperationMode) noexcept {
  return OperationMode::Automatic;
}
constexpr DriveState lastOf(DriveState) noexcept {
  return DriveState::Active;
}
constexpr ControlMode lastOf(ControlMode) noexcept {
  return ControlMode::NoControl;
}
constexpr ClientCommandMode lastOf(ClientCommandMode) noexcept {
  return ClientCommandMode::CartesianPose;
}
constexpr OverlayType lastOf(OverlayType) noexcept {
  return OverlayType::Cartesian;
}
constexpr IoType lastOf(IoType) noexcept {
  return IoType::Analog;
}
constexpr IoDirection lastOf(IoDirection) noexcept {
  return IoDirection::Output;
}

template <Choice T>
constexpr bool isKnown(T value) noexcept {
  return value <= lastOf(value);
}

// ---- protobuf's bytes ----

enum Wire : std::uint32_t {
  Varint = 0,
  Fixed64 = 1,
  Delimited = 2,
  Group = 3,
  EndOfGroup = 4,
  Fixed32 = 5
};

struct Tag {
  std::uint32_t number = 0;
  std::uint32_t wire = 0;
};

/// Reads what is inside one message. What goes wrong once ends it, and reads as zero.
class Reader {
 public:
  explicit Reader(std::span<const std::uint8_t> bytes, std::size_t depth = kDeepest) noexcept
      : rest_(bytes), depth_(depth) {}

  bool isSound() const noexcept { return isSound_; }
  bool hasMore() const noexcept { return isSound_ && !rest_.empty(); }
  void fail() noexcept { isSound_ = false; }

  /// What overflows is cut off, as protobuf does.
  std::uint64_t varint(std::size_t longest = kLongVarint) noexcept {
    std::uint64_t value = 0;
    const std::size_t most = std::min(longest, rest_.size());
    for (std::size_t i = 0; i < most; ++i) {
      value |= std::uint64_t{rest_[i] & 0x7FU} << (7 * i);
      if ((rest_[i] & 0x80U) == 0) {
        rest_ = rest_.subspan(i + 1);
        return value;
      }
    }
    fail();
    return 0;
  }

  double number() noexcept {
    const std::span<const std::uint8_t> bytes = take(8);
    std::uint64_t bits = 0;
    for (std::size_t i = 0; i < bytes.size(); ++i) bits |= std::uint64_t{bytes[i]} << (8 * i);
    return std::bit_cast<double>(bits);
  }

  std::span<const std::uint8_t> delimited() noexcept { return take(varint(kShortVarint)); }

  /// The reader of a message within this one.
  Reader nested() noexcept {
    if (depth_ == 0) fail();
    return Reader(delimited(), depth_ - (depth_ == 0 ? 0 : 1));
  }

  Tag tag() noexcept {
    const auto both = static_cast<std::uint32_t>(varint(kShortVarint));
    if (both >> 3U == 0) fail();
    return {both >> 3U, both & 7U};
  }

  /// Passes over an unknown field, with all groups that are in it.
  void skip(Tag tag) noexcept {
    std::array<std::uint32_t, kDeepest> open{};
    std::size_t count = 0;
    while (isSound_) {
      if (tag.wire == Group) {
        if (count >= depth_) return fail();
        open[count++] = tag.number;
      } else if (tag.wire == EndOfGroup) {
        if (count == 0 || open[--count] != tag.number) return fail();
      } else {
        skipPlain(tag.wire);
      }
      if (count == 0) return;
      tag = this->tag();
    }
  }

 private:
  std::span<const std::uint8_t> take(std::uint64_t count) noexcept {
    if (!isSound_ || count > rest_.size()) {
      fail();
      return {};
    }
    const auto size = static_cast<std::size_t>(count);
    const std::span<const std::uint8_t> taken = rest_.first(size);
    rest_ = rest_.subspan(size);
    return taken;
  }

  void skipPlain(std::uint32_t wire) noexcept {
    if (wire == Varint) {
      varint();
    } else if (wire == Fixed64) {
      take(8);
    } else if (wire == Delimited) {
      delimited();
    } else if (wire == Fixed32) {
      take(4);
    } else {
      fail();
    }
  }

  std::span<const std::uint8_t> rest_;
  std::size_t depth_;  // how many levels may still follow
  bool isSound_ = true;
};

/// Writes fields into a buffer. What goes wrong once ends it.
class Writer {
 public:
  Writer(std::span<std::uint8_t> out, Version version) noexcept : out_(out), version_(version) {}

  /// 0 if something went wrong.
  std::size_t size() const noexcept { return isSound_ ? size_ : 0; }

  template <typename T>
  void operator()(std::uint32_t number, const T& value, Known known) noexcept {
    if (knows(version_, known)) put(number, value);
  }

 private:
  template <typename T>
  void put(std::uint32_t number, const std::optional<T>& value) noexcept {
    if (value) put(number, *value);
  }

  void put(std::uint32_t number, Number auto value) noexcept {
    tag(number, Varint);
    varint(static_cast<std::uint64_t>(value));  // a negative int32 has ten bytes
  }

  void put(std::uint32_t number, double value) noexcept {
    tag(number, Fixed64);
    fixed(value);
  }

  void put(std::uint32_t number, Choice auto value) noexcept {
    if (!isKnown(value)) return fail();
    if constexpr (std::same_as<decltype(value), ClientCommandMode>) {
      if (value == ClientCommandMode::CartesianPose && !knows(version_, kTwo)) return;
    }
    put(number, static_cast<std::uint32_t>(value));
  }

  void put(std::uint32_t number, const Name& name) noexcept {
    if (name.size > name.bytes.size()) return fail();
    tag(number, Delimited);
    varint(name.size);
    for (const char c : name.text()) byte(static_cast<std::uint8_t>(c));
  }

  void put(std::uint32_t number, const Joints& joints) noexcept {
    nest(number, [&] {
      for (const double joint : joints) put(1, joint);
    });
  }

  void put(std::uint32_t number, const Vector6& vector) noexcept {
    nest(number, [&] { packed(1, vector); });
  }

  void put(std::uint32_t number, const List<double, 12>& elements) noexcept {
    if (elements.count > mostElements(version_)) return fail();
    if (elements.count > 0) packed(number, {elements.begin(), elements.count});
  }

  template <typename T, std::size_t N>
  void put(std::uint32_t number, const List<T, N>& list) noexcept {
    if (list.count > N) return fail();
    for (const T& item : list) put(number, item);
  }

  template <Message T>
  void put(std::uint32_t number, const T& message) noexcept {
    nest(number, [&] { visit(message, *this); });
  }

  void packed(std::uint32_t number, std::span<const double> values) noexcept {
    tag(number, Delimited);
    varint(8 * values.size());
    for (const double value : values) fixed(value);
  }

  /// Writes what is inside first, behind one byte for its length, and moves it if that is two.
  void nest(std::uint32_t number, const auto& writeInside) noexcept {
    tag(number, Delimited);
    byte(0);
    const std::size_t begin = size_;
    writeInside();
    if (!isSound_) return;
    const std::size_t inside = size_ - begin;
    if (inside >= 0x80) {
      byte(0);
      if (!isSound_) return;
      std::memmove(&out_[begin + 1], &out_[begin], inside);
    }
    const std::size_t end = size_;
    size_ = begin - 1;
    varint(inside);  // below 2^14, as no datagram has that many bytes
    size_ = end;
  }

  void tag(std::uint32_t number, Wire wire) noexcept { varint(number << 3U | wire); }

  void varint(std::uint64_t value) noexcept {
    for (; value >= 0x80; value >>= 7U) byte(static_cast<std::uint8_t>(value | 0x80U));
    byte(static_cast<std::uint8_t>(value));
  }

  void fixed(double value) noexcept {
    if (!std::isfinite(value)) return fail();
    const auto bits = std::bit_cast<std::uint64_t>(value);
    for (unsigned shift = 0; shift < 64; shift += 8) byte(static_cast<std::uint8_t>(bits >> shift));
  }

  void byte(std::uint8_t value) noexcept {
    if (size_ >= out_.size()) return fail();
    out_[size_++] = value;
  }

  void fail() noexcept { isSound_ = false; }

  std::span<std::uint8_t> out_;
  Version version_;
  std::size_t size_ = 0;
  bool isSound_ = true;
};

// ---- reading and judging messages ----

/// Remembers a number for each of a few places.
class Ledger {
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
  // A monitoring message has 29 places with something required, and 7 with joints or a vector.
  std::array<const void*, 40> places_{};
  std::array<std::uint32_t, 40> values_{};
  std::uint8_t count_ = 0;
};

/// Which numbers and names a message cannot do without, as bits. A message within it that is
/// required says so by its own needs.
class Needs {
 public:
  template <typename T>
  void operator()(std::uint32_t number, const T& /*value*/, Known /*known*/) noexcept {
    constexpr bool kIsPlain = std::is_arithmetic_v<T> || std::is_enum_v<T> || Is<T, Name>;
    if (kIsPlain) bits_ |= 1U << number;
  }

  std::uint32_t bits() const noexcept { return bits_; }

 private:
  std::uint32_t bits_ = 0;
};

std::uint32_t needsOf(const Message auto& message) noexcept {
  Needs needs;
  visit(message, needs);
  return needs.bits();
}

/// What reading found out besides the message.
struct Findings {
  Ledger seen;    ///< of a message's required fields, as bits
  Ledger counts;  ///< of joints and vectors
  bool isOverfull = false;
};

/// Looks over a message that was read, in ascending order of fields.
class Judge {
 public:
  Judge(const Findings& findings, Version version) noexcept
      : findings_(findings), version_(version) {}

  template <typename T>
  void operator()(std::uint32_t /*number*/, const T& value, Known /*known*/) noexcept {
    judge(value);
  }

  template <Message T>
  void judge(const T& message) noexcept {
    const std::uint32_t needs = needsOf(message);
    if (needs != 0 && (needs & ~findings_.seen.at(&message)) != 0) isIncomplete_ = true;
    visit(message, *this);
  }

  /// Something that is required is missing.
  bool isIncomplete() const noexcept { return isIncomplete_; }
  Refusal first() const noexcept { return first_; }

 private:
  template <typename T>
  void judge(const std::optional<T>& value) noexcept {
    if (value) judge(*value);
  }

  template <typename T>
  void judge(const T& /*value*/) noexcept requires(Number<T> || Choice<T>) {}
  void judge(const Name& /*value*/) noexcept {}
  void judge(double value) noexcept { expect(std::isfinite(value), Refusal::NotFinite); }

  void judge(const Joints& joints) noexcept { judgeArray(joints, Refusal::JointCount); }
  void judge(const Vector6& vector) noexcept { judgeArray(vector, Refusal::ElementCount); }

  template <std::size_t N>
  void judgeArray(const std::array<double, N>& values, Refusal ifOtherCount) noexcept {
    expect(findings_.counts.at(&values) == N, ifOtherCount);
    for (const double value : values) judge(value);
  }

  void judge(const List<double, 12>& elements) noexcept {
    expect(elements.count <= mostElements(version_), Refusal::ElementCount);
    for (const double element : elements) judge(element);
  }

  template <typename T, std::size_t N>
  void judge(const List<T, N>& list) noexcept {
    for (const T& item : list) judge(item);
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

/// Takes one field, whichever of a message's it is.
class Taker {
 public:
  Taker(Reader& in, Tag tag, Findings& findings) noexcept
      : in_(in), tag_(tag), findings_(findings) {}

  template <typename T>
  void operator()(std::uint32_t number, T& value, Known /*known*/) noexcept {
    if (number == tag_.number) isTaken_ = take(value);
  }

  bool isTaken() const noexcept { return isTaken_; }
  /// It had a value that counts.
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
    if (bytes.size() > name.bytes.size()) findings_.isOverfull = true;
    name = Name{};
    name.size = std::min(bytes.size(), name.bytes.size());
    std::copy_n(bytes.begin(), name.size, name.bytes.begin());
    return hasValue_ = true;
  }

  bool take(Joints& joints) noexcept { return takeArray(joints); }
  bool take(Vector6& vector) noexcept { return takeArray(vector); }
  bool take(List<double, 12>& elements) noexcept {
    return takeNumbers(in_, tag_, [&](double value) { append(elements, value); });
  }

  bool take(List<DriveState, 7>& states) noexcept {
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
  bool take(List<T, N>& list) noexcept {
    if (!is(Delimited)) return false;
    T* const place = list.add();
    return place != nullptr ? take(*place) : takeSurplus<T>();
  }

  /// What a list has no place for may still be malformed.
  template <Message T>
  bool takeSurplus() noexcept {
    T surplus;
    Findings findings;
    Judge judge(findings, Version::V1_11);
    const bool isSound = read(in_.nested(), surplus, findings);
    judge.judge(surplus);
    if (!isSound || judge.isIncomplete()) in_.fail();
    findings_.isOverfull = true;
    return true;
  }

  template <Message T>
  bool take(T& message) noexcept {
    if (!is(Delimited)) return false;
    if (!read(in_.nested(), message, findings_)) in_.fail();
    return hasValue_ = true;
  }

  /// Joints and vectors are messages on the wire, with one field: their numbers.
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

  void takeDriveState(Reader& in, List<DriveState, 7>& states) noexcept {
    if (const std::optional<DriveState> state = choice<DriveState>(in)) append(states, *state);
  }

  template <typename T, std::size_t N>
  void append(List<T, N>& list, T value) noexcept {
    if (T* const place = list.add()) {
      *place = value;
    } else {
      findings_.isOverfull = true;
    }
  }

  /// A value of an enumeration; nothing if it is unknown. Like protobuf it reads 32 bits.
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
  std::uint32_t seen = 0;
  while (in.hasMore()) {
    const Tag tag = in.tag();
    Taker field(in, tag, findings);
    visit(message, field);
    if (!field.isTaken()) in.skip(tag);
    if (field.hasValue()) seen |= 1U << tag.number;
  }
  if (needsOf(message) != 0) findings.seen[&message] |= seen;
  return in.isSound();
}

Refusal judgeOwn(const MonitoringMessage& message) noexcept {
  const bool isCommanding =
      message.connection && message.connection->state >= SessionState::CommandingWait;
  const bool hasPosition = message.ipoData && message.ipoData->jointPosition;
  return isCommanding && !hasPosition ? Refusal::MissingIpoJointPosition : Refusal::None;
}

Refusal judgeOwn(const CommandMessage& /*message*/) noexcept {
  return Refusal::None;
}

template <typename T>
Refusal readMessage(std::span<const std::uint8_t> bytes, Version version, T& out) noexcept {
  const std::uint32_t identifier = T{}.header.identifier;
  T message;
  Findings findings;
  if (!read(Reader(bytes), message, findings)) return Refusal::Malformed;
  Judge judge(findings, version);
  judge.judge(message);
  if (judge.isIncomplete()) return Refusal::Malformed;
  if (message.header.identifier != identifier) return Refusal::WrongIdentifier;
  if (findings.isOverfull) return Refusal::ElementCount;
  if (judge.first() != Refusal::None) return judge.first();
  const Refusal own = judgeOwn(message);
  if (own == Refusal::None) out = message;
  return own;
}

// ---- the frame of 2.7 ----

std::uint32_t wordAt(const std::uint8_t* bytes) noexcept {
  std::uint32_t word = 0;
  for (unsigned i = 0; i < 4; ++i) word |= std::uint32_t{bytes[i]} << (8 * i);
  return word;
}

void putWord(std::uint8_t* bytes, std::uint32_t word) noexcept {
  for (unsigned i = 0; i < 4; ++i) bytes[i] = static_cast<std::uint8_t>(word >> (8 * i));
}

Refusal judgeFrame(std::span<const std::uint8_t> datagram) noexcept {
  if (datagram.size() < kFrameSize) return Refusal::TooShort;
  const std::size_t inside = datagram.size() - kFrameSize;
  if (wordAt(datagram.data()) != inside) return Refusal::LengthMismatch;
  const std::uint8_t* const bytes = datagram.data() + kLengthSize;
  return crc32(bytes, inside) == wordAt(bytes + inside) ? Refusal::None : Refusal::CrcMismatch;
}

template <typename T>
Refusal decodeAny(std::span<const std::uint8_t> datagram, Version version, T& out) noexcept {
  if (datagram.size() > kLargestDatagram) return Refusal::TooLong;
  if (!knows(version, kLast)) return readMessage(datagram, version, out);
  const Refusal refusal = judgeFrame(datagram);
  if (refusal != Refusal::None) return refusal;
  return readMessage(datagram.subspan(kLengthSize, datagram.size() - kFrameSize), version, out);
}

template <typename T>
std::size_t encodeAny(const T& message, Version version, std::span<std::uint8_t> out) noexcept {
  out = out.first(std::min(out.size(), kLargestDatagram));
  const bool isFramed = knows(version, kLast);
  const std::size_t frame = isFramed ? kFrameSize : 0;
  if (out.size() < frame) return 0;
  const std::size_t begin = frame / 2;
  Writer writer(out.subspan(begin, out.size() - frame), version);
  visit(message, writer);
  const std::size_t size = writer.size();  // never 0 for a message: the header is required
  if (size == 0 || !isFramed) return size;
  std::uint8_t* const bytes = out.data() + begin;
  putWord(out.data(), static_cast<std::uint32_t>(size));
  putWord(bytes + size, crc32(bytes, size));
  return size + frame;
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

std::size_t encode(
    const MonitoringMessage& message, Version version, std::span<std::uint8_t> out) noexcept {
  return encodeAny(message, version, out);
}

std::size_t encode(
    const CommandMessage& message, Version version, std::span<std::uint8_t> out) noexcept {
  return encodeAny(message, version, out);
}

}  // namespace haptics::wire::fri
