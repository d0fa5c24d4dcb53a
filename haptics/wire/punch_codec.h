#pragma once

#include "haptics/wire/punch_frame.h"

/// Reads and writes the payloads of docs/punch-protocol.md.
namespace haptics::wire::punch {

template <typename Message>
void write(Writer& writer, const Message& message) noexcept {
  Message::visit(message, writer);
}

/// Returns false if the payload has the wrong length or an invalid value.
template <typename Message>
bool read(const Frame& frame, Message& message) noexcept {
  Reader reader(frame.payload, frame.size);
  Message::visit(message, reader);
  if constexpr (requires { message.isValid(); }) return reader.isSound() && message.isValid();
  return reader.isSound();
}

/// Encodes a message into @p wire, which has space for kLargestOnWire bytes. @p time is the
/// sender's clock [µs]. Returns the number of bytes.
template <typename Message>
size_t encode(const Message& message, uint16_t sequence, uint32_t time, uint8_t* wire) noexcept {
  uint8_t payload[kLargestPayload];
  Writer writer(payload);
  write(writer, message);
  return encodeFrame(Message::kType, sequence, time, payload, writer.size(), wire);
}

}  // namespace haptics::wire::punch
