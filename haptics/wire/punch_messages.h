#pragma once

#include <stddef.h>
#include <stdint.h>

/// The messages between a punch and its host: docs/punch-protocol.md. Compiled for both sides.
namespace haptics::wire::punch {

inline constexpr uint16_t kProtocolVersion = 1;

/// The type of a frame, and its direction.
enum class Type : uint8_t {
  Hello = 0x01,       ///< both ways; the first message
  Arm = 0x02,         ///< to the device
  SetForce = 0x10,    ///< to the device
  State = 0x11,       ///< from the device, once a loop
  Event = 0x12,       ///< from the device
  Model = 0x20,       ///< to the device
  ModelTable = 0x21,  ///< to the device
  ModelReply = 0x22,  ///< from the device
  Render = 0x23,      ///< to the device
  Stop = 0x7F,        ///< both ways
};

inline constexpr uint8_t kLongestExpiry = 20;  ///< [ms]

constexpr bool isValidExpiry(uint8_t expiry) noexcept {
  return expiry >= 1 && expiry <= kLongestExpiry;
}

// Each message has its type, and visit(), which calls @p field with its members in the order of its
// payload. isValid(): whether a received message has only values that the protocol allows.

/// Identity and limits of a side. The host fills in its protocol version and 0 elsewhere.
struct Hello {
  static constexpr Type kType = Type::Hello;

  uint16_t protocolVersion = kProtocolVersion;
  uint64_t build = 0;          ///< of the firmware: first 8 bytes of the hash of its sources
  uint32_t serial = 0;         ///< serial number of the device; 0: none
  uint16_t counts = 0;         ///< counts of the encoder per revolution
  uint16_t rate = 0;           ///< of the device's loop [Hz]
  int16_t largestVoltage = 0;  ///< largest voltage of the motor [mV]
  uint16_t largestSlew = 0;    ///< largest change of the voltage per millisecond [mV]

  static void visit(auto& m, auto& field) noexcept {
    field(m.protocolVersion, m.build, m.serial, m.counts, m.rate, m.largestVoltage, m.largestSlew);
  }
};

struct Arm {
  static constexpr Type kType = Type::Arm;

  bool isArmed = false;
  uint8_t expiry = 20;  ///< longest time for which a force may last without a new one [ms], 1 to 20

  static void visit(auto& m, auto& field) noexcept { field(m.isArmed, m.expiry); }
  bool isValid() const noexcept { return isValidExpiry(expiry); }
};

/// Sets the voltage on the motor, until the next message or until it expires.
struct SetForce {
  static constexpr Type kType = Type::SetForce;

  int16_t voltage = 0;  ///< [mV]
  uint8_t expiry = 10;  ///< [ms], 1 to 20

  static void visit(auto& m, auto& field) noexcept { field(m.voltage, m.expiry); }
  bool isValid() const noexcept { return isValidExpiry(expiry); }
};

/// Bits of State::faults.
enum Fault : uint8_t {
  kNoFault = 0,
  kExpired = 1,      ///< no valid force came in time, so the voltage went to 0
  kSaturated = 2,    ///< a voltage beyond the limit was requested
  kTooFast = 4,      ///< the velocity is impossible for a hand; off until armed again
  kDriverFault = 8,  ///< the motor's driver reports a fault; off until armed again
  /// A change of counts that is impossible for the mechanism; off until armed again.
  kEncoderFault = 16,
  kBadFrames = 32,     ///< damaged frames were received since the last State
  kNotArmed = 64,      ///< not armed, so there is no voltage
  kClockWrapped = 128  ///< the device's clock has wrapped to 0
};
/// Faults that last until the device is armed again.
inline constexpr uint8_t kLatchedFaults = kTooFast | kDriverFault | kEncoderFault;

struct State {
  static constexpr Type kType = Type::State;

  int32_t counts = 0;    ///< of the encoder
  int32_t velocity = 0;  ///< [counts/s]
  int16_t voltage = 0;   ///< present voltage on the motor [mV]
  uint8_t faults = 0;
  uint16_t echo = 0;         ///< sequence of the last valid frame from the host
  uint16_t lateLoops = 0;    ///< since Hello
  uint16_t badFrames = 0;    ///< since Hello
  bool isRendering = false;  ///< the device computes the force itself

  static void visit(auto& m, auto& field) noexcept {
    field(
        m.counts, m.velocity, m.voltage, m.faults, m.echo, m.lateLoops, m.badFrames, m.isRendering);
  }
};

enum class EventCode : uint8_t {
  WatchdogFired = 1,
  DriverFault = 2,
  EncoderFault = 3,
  TooFast = 4,
  Armed = 5,
  Disarmed = 6,
  Reset = 7,
};

struct Event {
  static constexpr Type kType = Type::Event;

  EventCode code = EventCode::Reset;
  uint32_t value = 0;

  static void visit(auto& m, auto& field) noexcept { field(m.code, m.value); }
};

enum class ModelKind : uint8_t { None = 0, Interpolation = 1, FiniteElements = 2, Kalman = 3 };

inline constexpr int kLargestTable = 128;
inline constexpr int kTableChunk = 16;

/// A scene for the device to render itself, without the points of its curve (ModelTable).
struct Model {
  static constexpr Type kType = Type::Model;

  ModelKind kind = ModelKind::None;
  uint8_t tableSize = 0;        ///< points of the curve, up to kLargestTable
  float travelPerCount = 0.0F;  ///< [travel units]
  float travelAtZero = 0.0F;    ///< travel at count 0 [travel units]
  float millivoltsPerNewton = 0.0F;
  float largestForce = 0.0F;  ///< [N]
  // Finite elements: haptics/models/finite_elements.h.
  uint8_t elements = 5;
  uint8_t equationVariants = 0;  ///< boundary | weights << 1 | yielding << 3
  float start = 0.5F;
  float end = 2.0F;
  float elementStiffness = 1.0F;
  float toolPosition = 1.5F;
  float contact = 4.0F;
  float yieldForce = 7.0F;
  // Interpolation: haptics/models/interpolation.h.
  uint8_t extrapolation = 0;
  float rampLength = 1.5F;
  // Kalman filter: haptics/models/kalman_filter.h.
  uint8_t scheme = 0;
  float noise[6] = {};  ///< the members of KalmanNoise in their order

  static void visit(auto& m, auto& field) noexcept {
    field(
        m.kind,
        m.tableSize,
        m.travelPerCount,
        m.travelAtZero,
        m.millivoltsPerNewton,
        m.largestForce);
    field(
        m.elements,
        m.equationVariants,
        m.start,
        m.end,
        m.elementStiffness,
        m.toolPosition,
        m.contact,
        m.yieldForce);
    field(m.extrapolation, m.rampLength, m.scheme);
    for (auto& v : m.noise) field(v);
  }
  bool isValid() const noexcept {
    return kind <= ModelKind::Kalman && tableSize <= kLargestTable && equationVariants < 16 &&
           extrapolation < 5 && scheme < 4;
  }
};

/// Some points of the curve of a Model.
struct ModelTable {
  static constexpr Type kType = Type::ModelTable;

  uint8_t first = 0;
  uint8_t count = 0;               ///< up to kTableChunk
  float travel[kTableChunk] = {};  ///< [travel units]
  float force[kTableChunk] = {};   ///< [N]

  static void visit(auto& m, auto& field) noexcept {
    field(m.first, m.count);
    for (int i = 0; i < m.count && i < kTableChunk; ++i) field(m.travel[i], m.force[i]);
  }
  bool isValid() const noexcept { return count <= kTableChunk && first + count <= kLargestTable; }
};

/// Whether the device accepts a model, or why not.
enum class ModelVerdict : uint8_t { Accepted = 0, Incomplete = 1, InvalidModel = 2, Armed = 3 };

struct ModelReply {
  static constexpr Type kType = Type::ModelReply;

  ModelVerdict verdict = ModelVerdict::Accepted;
  uint32_t hash = 0;  ///< CRC-32 of the payloads of Model and ModelTable in the order received

  static void visit(auto& m, auto& field) noexcept { field(m.verdict, m.hash); }
  bool isValid() const noexcept { return verdict <= ModelVerdict::Armed; }
};

/// Makes the device render its model, until the next message or until it expires.
struct Render {
  static constexpr Type kType = Type::Render;

  uint32_t hash = 0;    ///< ModelReply::hash of the model; the device renders no other
  uint8_t expiry = 10;  ///< [ms], 1 to 20
  /// Largest voltage in either direction [mV], >= 0: the limit that the host sets.
  int16_t most = 32767;

  static void visit(auto& m, auto& field) noexcept { field(m.hash, m.expiry, m.most); }
  bool isValid() const noexcept { return isValidExpiry(expiry) && most >= 0; }
};

enum class StopReason : uint8_t {
  Requested = 0,
  VersionMismatch = 1,
  HostFault = 2,
  DeviceFault = 3
};

struct Stop {
  static constexpr Type kType = Type::Stop;

  StopReason reason = StopReason::Requested;

  static void visit(auto& m, auto& field) noexcept { field(m.reason); }
};

}  // namespace haptics::wire::punch
