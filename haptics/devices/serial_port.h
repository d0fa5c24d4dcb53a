#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace haptics::devices {

/// A serial port in raw mode, without an event loop, for a real-time thread. Closes itself at the
/// first error and is reopened only by open().
class SerialPort {
 public:
  SerialPort() = default;
  ~SerialPort() { close(); }
  SerialPort(const SerialPort&) = delete;
  SerialPort& operator=(const SerialPort&) = delete;

  /// Whether this system supports @p baud; always true for 0 (USB).
  static bool supportsBaud(int baud) noexcept;
  /// The supported speeds as a text: "115200, … or 2000000".
  static std::string supportedSpeeds();

  /// @param baud  0: do not set a speed (USB and pseudo-terminals have none).
  /// @throws DeviceError  if the port does not exist, is not permitted, is in use, or is no serial
  ///                      port.
  void open(const std::string& path, int baud);
  void close() noexcept;
  bool isOpen() const noexcept { return descriptor_ >= 0; }

  /// Waits until there is something to read, or @p deadline [ns on CLOCK_MONOTONIC].
  void waitReadable(std::int64_t deadline) noexcept;

  /// Reads the available bytes, at most the size of @p into, and returns their number. Closes the
  /// port if the line has failed.
  std::size_t read(std::span<std::uint8_t> into) noexcept;

  /// Writes all bytes or none: false if the buffer is full. Closes the port if the line has failed.
  bool write(std::span<const std::uint8_t> bytes) noexcept;

  /// Discards all received bytes.
  void discardInput() noexcept;

 private:
  int descriptor_ = -1;
  bool isExclusive_ = false;
};

/// Paths of the serial ports of this computer, by stable names (/dev/serial/by-id) where they
/// exist.
std::vector<std::string> serialPorts();

}  // namespace haptics::devices
