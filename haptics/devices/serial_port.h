#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace haptics::devices {

/// A serial line, raw, without an event loop: for a thread that ticks. Closed at the first error;
/// only its owner opens it again.
class SerialPort {
 public:
  SerialPort() = default;
  ~SerialPort() { close(); }
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /// Whether this computer has a line at @p baud; 0, for USB, always.
  static bool canGoAt(int baud) noexcept;
  /// The others, in words: "115200, … or 2000000".
  static std::string supportedSpeeds();

  /// @param baud  0: as it is (USB and pseudo-terminals have none).
  /// @throws DeviceError  if it is not there, not allowed, in use, or no serial line.
  void open(const std::string& path, int baud);
  void close() noexcept;
  bool isOpen() const noexcept { return descriptor_ >= 0; }

  /// Waits until there is something to read, or @p deadline [ns on CLOCK_MONOTONIC].
  void waitReadable(std::int64_t deadline) noexcept;

  /// What has come, up to the size of @p into; 0 for nothing. Closes where the line is gone.
  std::size_t read(std::span<std::uint8_t> into) noexcept;

  /// Writes all bytes or none: false if the buffer is full. Closes the port if the line has failed.
  bool write(std::span<const std::uint8_t> bytes) noexcept;

  /// Throws away what has come.
  void discardInput() noexcept;

 private:
  int descriptor_ = -1;
};

/// The serial lines of this computer, by names that stay (/dev/serial/by-id) where there are any.
std::vector<std::string> serialPorts();

}  // namespace haptics::devices
