#pragma once

#include "haptics/wire/punch_frame.h"

/// Reads and writes the payloads of docs/punch-protocol.md. read() returns false if the payload has
/// the wrong length or an invalid value.
namespace haptics::wire::punch {

inline bool isFinite(float value) noexcept {
  return value - value == 0.0F;
}

inline void write(Writer& w, const Hello& m) noexcept {
  w.u16(m.protocolVersion);
  w.u64(m.build);
  w.u32(m.serial);
  w.u16(m.counts);
  w.u16(m.rate);
  w.i16(m.largestVoltage);
  w.u16(m.largestSlew);
}

inline bool read(const Frame& frame, Hello& m) noexcept {
  Reader r(frame.payload, frame.size);
  m.protocolVersion = r.u16();
  m.build = r.u64();
  m.serial = r.u32();
  m.counts = r.u16();
  m.rate = r.u16();
  m.largestVoltage = r.i16();
  m.largestSlew = r.u16();
  return r.isFullyRead();
}

inline constexpr uint8_t kLongestExpiry = 20;  ///< [ms]

inline bool isValidExpiry(uint8_t expiry) noexcept {
  return expiry >= 1 && expiry <= kLongestExpiry;
}

inline void write(Writer& w, const Arm& m) noexcept {
  w.u8(m.isArmed ? 1 : 0);
  w.u8(m.expiry);
}

inline bool read(const Frame& frame, Arm& m) noexcept {
  Reader r(frame.payload, frame.size);
  const uint8_t armed = r.u8();
  m.isArmed = armed == 1;
  m.expiry = r.u8();
  return r.isFullyRead() && armed <= 1 && isValidExpiry(m.expiry);
}

inline void write(Writer& w, const SetForce& m) noexcept {
  w.i16(m.voltage);
  w.u8(m.expiry);
}

inline bool read(const Frame& frame, SetForce& m) noexcept {
  Reader r(frame.payload, frame.size);
  m.voltage = r.i16();
  m.expiry = r.u8();
  return r.isFullyRead() && isValidExpiry(m.expiry);
}

inline void write(Writer& w, const State& m) noexcept {
  w.i32(m.counts);
  w.i32(m.velocity);
  w.i16(m.voltage);
  w.u8(m.faults);
  w.u16(m.echo);
  w.u16(m.lateLoops);
  w.u16(m.badFrames);
  w.u8(m.isRendering ? 1 : 0);
}

inline bool read(const Frame& frame, State& m) noexcept {
  Reader r(frame.payload, frame.size);
  m.counts = r.i32();
  m.velocity = r.i32();
  m.voltage = r.i16();
  m.faults = r.u8();
  m.echo = r.u16();
  m.lateLoops = r.u16();
  m.badFrames = r.u16();
  const uint8_t rendering = r.u8();
  m.isRendering = rendering == 1;
  return r.isFullyRead() && rendering <= 1;
}

inline void write(Writer& w, const Event& m) noexcept {
  w.u8(static_cast<uint8_t>(m.code));
  w.u32(m.value);
}

inline bool read(const Frame& frame, Event& m) noexcept {
  Reader r(frame.payload, frame.size);
  m.code = static_cast<EventCode>(r.u8());
  m.value = r.u32();
  return r.isFullyRead();
}

inline void write(Writer& w, const Model& m) noexcept {
  w.u8(static_cast<uint8_t>(m.kind));
  w.u8(m.tableSize);
  w.f32(m.travelPerCount);
  w.f32(m.travelAtZero);
  w.f32(m.millivoltsPerNewton);
  w.f32(m.largestForce);
  w.u8(m.elements);
  w.u8(m.equationVariants);
  w.f32(m.start);
  w.f32(m.end);
  w.f32(m.elementStiffness);
  w.f32(m.toolPosition);
  w.f32(m.contact);
  w.f32(m.yieldForce);
  w.u8(m.extrapolation);
  w.f32(m.rampLength);
  w.u8(m.scheme);
  for (const float v : m.noise) w.f32(v);
}

inline bool read(const Frame& frame, Model& m) noexcept {
  Reader r(frame.payload, frame.size);
  m.kind = static_cast<ModelKind>(r.u8());
  m.tableSize = r.u8();
  bool isNumber = true;
  const auto f32 = [&](float& value) {
    value = r.f32();
    isNumber = isNumber && isFinite(value);
  };
  f32(m.travelPerCount);
  f32(m.travelAtZero);
  f32(m.millivoltsPerNewton);
  f32(m.largestForce);
  m.elements = r.u8();
  m.equationVariants = r.u8();
  f32(m.start);
  f32(m.end);
  f32(m.elementStiffness);
  f32(m.toolPosition);
  f32(m.contact);
  f32(m.yieldForce);
  m.extrapolation = r.u8();
  f32(m.rampLength);
  m.scheme = r.u8();
  for (float& v : m.noise) f32(v);
  return r.isFullyRead() && isNumber && m.kind <= ModelKind::Kalman &&
         m.tableSize <= kLargestTable && m.equationVariants < 16 && m.extrapolation < 5 &&
         m.scheme < 4;
}

inline void write(Writer& w, const ModelTable& m) noexcept {
  w.u8(m.first);
  w.u8(m.count);
  for (int i = 0; i < m.count; ++i) {
    w.f32(m.travel[i]);
    w.f32(m.force[i]);
  }
}

inline bool read(const Frame& frame, ModelTable& m) noexcept {
  Reader r(frame.payload, frame.size);
  m.first = r.u8();
  m.count = r.u8();
  if (m.count > kTableChunk || m.first + m.count > kLargestTable) return false;
  bool isNumber = true;
  for (int i = 0; i < m.count; ++i) {
    m.travel[i] = r.f32();
    m.force[i] = r.f32();
    isNumber = isNumber && isFinite(m.travel[i]) && isFinite(m.force[i]);
  }
  return r.isFullyRead() && isNumber;
}

inline void write(Writer& w, const ModelReply& m) noexcept {
  w.u8(static_cast<uint8_t>(m.verdict));
  w.u32(m.hash);
}

inline bool read(const Frame& frame, ModelReply& m) noexcept {
  Reader r(frame.payload, frame.size);
  m.verdict = static_cast<ModelVerdict>(r.u8());
  m.hash = r.u32();
  return r.isFullyRead() && m.verdict <= ModelVerdict::Armed;
}

inline void write(Writer& w, const Render& m) noexcept {
  w.u32(m.hash);
  w.u8(m.expiry);
  w.i16(m.most);
}

inline bool read(const Frame& frame, Render& m) noexcept {
  Reader r(frame.payload, frame.size);
  m.hash = r.u32();
  m.expiry = r.u8();
  m.most = r.i16();
  return r.isFullyRead() && isValidExpiry(m.expiry) && m.most >= 0;
}

inline void write(Writer& w, const Stop& m) noexcept {
  w.u8(static_cast<uint8_t>(m.reason));
}

inline bool read(const Frame& frame, Stop& m) noexcept {
  Reader r(frame.payload, frame.size);
  m.reason = static_cast<StopReason>(r.u8());
  return r.isFullyRead();
}

constexpr Type typeOf(const Hello&) noexcept {
  return Type::Hello;
}
constexpr Type typeOf(const Arm&) noexcept {
  return Type::Arm;
}
constexpr Type typeOf(const SetForce&) noexcept {
  return Type::SetForce;
}
constexpr Type typeOf(const State&) noexcept {
  return Type::State;
}
constexpr Type typeOf(const Event&) noexcept {
  return Type::Event;
}
constexpr Type typeOf(const Model&) noexcept {
  return Type::Model;
}
constexpr Type typeOf(const ModelTable&) noexcept {
  return Type::ModelTable;
}
constexpr Type typeOf(const ModelReply&) noexcept {
  return Type::ModelReply;
}
constexpr Type typeOf(const Render&) noexcept {
  return Type::Render;
}
constexpr Type typeOf(const Stop&) noexcept {
  return Type::Stop;
}

/// Encodes a message into @p wire, which has space for kLargestOnWire bytes. @p time is the
/// sender's clock [µs]. Returns the number of bytes.
template <typename Message>
size_t encode(const Message& message, uint16_t sequence, uint32_t time, uint8_t* wire) noexcept {
  uint8_t payload[kLargestPayload];
  Writer writer(payload);
  write(writer, message);
  return encodeFrame(typeOf(message), sequence, time, payload, writer.size(), wire);
}

}  // namespace haptics::wire::punch
