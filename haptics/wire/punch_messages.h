#pragma once

#include <stddef.h>
#include <stdint.h>

/// What a punch and its host tell each other: docs/punch-protocol.md. Compiled for both ends.
namespace haptics::wire::punch {

inline constexpr uint16_t kProtocolVersion = 1;

/// Whose frame it is, and what comes in it.
enum class Type : uint8_t {
  Hello = 0x01,       ///< both ways, first of all
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

/// Identity and limits of a side. The host fills in its protocol version and 0 elsewhere.
struct Hello {
  uint16_t protocolVersion = kProtocolVersion;
  uint64_t build = 0;          ///< of the firmware: first 8 bytes of the hash of its sources
  uint32_t serial = 0;         ///< of the device, 0: it has none
  uint16_t counts = 0;         ///< of the encoder per revolution
  uint16_t rate = 0;           ///< of the device's loop [Hz]
  int16_t largestVoltage = 0;  ///< largest voltage of the motor [mV]
  uint16_t largestSlew = 0;    ///< how far the voltage moves in a millisecond [mV]
};

struct Arm {
  bool isArmed = false;
  uint8_t expiry = 20;  ///< after which a force is gone at the latest [ms], 1 to 20
};

/// The voltage on the motor, until the next one or until it expires.
struct SetForce {
  int16_t voltage = 0;  ///< [mV]
  uint8_t expiry = 10;  ///< [ms], 1 to 20
};

/// What is wrong, as bits of State::faults.
enum Fault : uint8_t {
  kNoFault = 0,
  kExpired = 1,        ///< no valid force came in time: the voltage went to nothing
  kSaturated = 2,      ///< a voltage beyond the limit was asked for
  kTooFast = 4,        ///< the encoder moves faster than any hand: off until armed again
  kDriverFault = 8,    ///< the motor's driver says so: off until armed again
  kEncoderFault = 16,  ///< counts that no mechanism makes: off until armed again
  kBadFrames = 32,     ///< frames that were damaged have been seen since the last State
  kNotArmed = 64,      ///< no voltage until it is armed
  kClockWrapped = 128  ///< the device's clock has begun again at 0
};
/// Faults that only arming again ends.
inline constexpr uint8_t kLatched = kTooFast | kDriverFault | kEncoderFault;

struct State {
  int32_t counts = 0;    ///< of the encoder
  int32_t velocity = 0;  ///< [counts/s]
  int16_t voltage = 0;   ///< on the motor now [mV]
  uint8_t faults = 0;
  uint16_t echo = 0;         ///< sequence of the last valid frame from the host
  uint16_t lateLoops = 0;    ///< since Hello
  uint16_t badFrames = 0;    ///< since Hello
  bool isRendering = false;  ///< the device renders by itself
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
  EventCode code = EventCode::Reset;
  uint32_t value = 0;
};

enum class ModelKind : uint8_t { None = 0, Interpolation = 1, FiniteElements = 2, Kalman = 3 };

/// A scene for the device to render by itself, but for the points of its curve (ModelTable).
struct Model {
  ModelKind kind = ModelKind::None;
  uint8_t tableSize = 0;        ///< points of the curve, up to kLargestTable
  float travelPerCount = 0.0F;  ///< [travel units]
  float travelAtZero = 0.0F;    ///< at count 0 [travel units]
  float millivoltsPerNewton = 0.0F;
  float largestForce = 0.0F;  ///< [N]
  // Finite elements: haptics/models/finite_elements.h.
  uint8_t elements = 5;
  uint8_t readings = 0;  ///< boundary | weights << 1 | yielding << 3
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
  float noise[6] = {};  ///< in the order of KalmanNoise
};

inline constexpr int kLargestTable = 128;
inline constexpr int kTableChunk = 16;

/// Some points of the curve of a Model.
struct ModelTable {
  uint8_t first = 0;
  uint8_t count = 0;               ///< up to kTableChunk
  float travel[kTableChunk] = {};  ///< [travel units]
  float force[kTableChunk] = {};   ///< [N]
};

/// Whether the device renders a model, and why not.
enum class ModelVerdict : uint8_t { Accepted = 0, Incomplete = 1, Unsound = 2, Armed = 3 };

struct ModelReply {
  ModelVerdict verdict = ModelVerdict::Accepted;
  uint32_t hash = 0;  ///< CRC-32 of the payloads of Model and ModelTable as they came
};

/// Lets the device render by itself, until the next one or until it expires.
struct Render {
  uint32_t hash = 0;    ///< of the model that is meant; another is not rendered
  uint8_t expiry = 10;  ///< [ms], 1 to 20
  int16_t most =
      32767;  ///< largest voltage in either direction [mV], >= 0: the limit that the host sets
};

enum class StopReason : uint8_t { Asked = 0, VersionMismatch = 1, HostFault = 2, DeviceFault = 3 };

struct Stop {
  StopReason reason = StopReason::Asked;
};

}  // namespace haptics::wire::punch
