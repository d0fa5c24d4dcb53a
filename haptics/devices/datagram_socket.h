#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace haptics::devices {

/// An address and port of IPv4, in the order of this machine.
struct Endpoint {
  std::uint32_t address = 0x7F000001;  ///< 127.0.0.1
  std::uint16_t port = 0;              ///< 0: any that is free

  bool isLoopback() const noexcept { return address >> 24U == 127; }
  std::string text() const;  ///< "127.0.0.1:30200"
  friend bool operator==(const Endpoint&, const Endpoint&) = default;
};

/// Reads "127.0.0.1:30200" or "127.0.0.1", which leaves @p port as it is.
std::optional<Endpoint> endpointFrom(std::string_view text, std::uint16_t port = 0);

/// The network does not do what was asked of it, in words.
class NetworkError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One UDP socket, not connected: it receives from any sender and returns the sender. After
/// construction nothing throws, allocates, or waits but receive().
class DatagramSocket {
 public:
  /// @throws NetworkError  if @p local cannot be had.
  explicit DatagramSocket(const Endpoint& local);
  ~DatagramSocket();
  DatagramSocket(const DatagramSocket&) = delete;
  DatagramSocket& operator=(const DatagramSocket&) = delete;

  /// False if the system did not take it.
  bool send(std::span<const std::uint8_t> datagram, const Endpoint& to) noexcept;

  struct Received {
    std::size_t size = 0;  ///< [bytes]; never more than there was room
    Endpoint from;
  };
  /// The next datagram; waits at most @p wait [ns] for it. What has no room is cut off: give it a
  /// byte more than may come.
  std::optional<Received> receive(std::span<std::uint8_t> room, std::int64_t wait = 0) noexcept;

  /// Where it is, with the port that it was given.
  const Endpoint& local() const noexcept { return local_; }

 private:
  int descriptor_;
  Endpoint local_;
};

}  // namespace haptics::devices
