#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>

namespace haptics::devices {

/// An IPv4 address and port, both in host byte order.
struct Endpoint {
  std::uint32_t address = 0x7F000001;  ///< 127.0.0.1
  std::uint16_t port = 0;              ///< 0: any free port

  bool isLoopback() const noexcept { return address >> 24U == 127; }
  std::string text() const;  ///< "127.0.0.1:30200"
  friend bool operator==(const Endpoint&, const Endpoint&) = default;
};

/// Parses "127.0.0.1:30200", or "127.0.0.1" for the default @p port; std::nullopt if @p text is
/// neither.
std::optional<Endpoint> endpointFrom(std::string_view text, std::uint16_t port = 0);

/// A socket cannot be opened; what() is a message for the operator.
class NetworkError : public std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// One UDP socket, not connected: it receives from any sender and returns the sender. After
/// construction no function throws or allocates, and only receive() waits.
class DatagramSocket {
 public:
  /// @throws NetworkError  if the socket cannot be bound to @p local.
  explicit DatagramSocket(const Endpoint& local);
  ~DatagramSocket();
  DatagramSocket(const DatagramSocket&) = delete;
  DatagramSocket& operator=(const DatagramSocket&) = delete;

  /// Returns false if the system did not accept the datagram.
  bool send(std::span<const std::uint8_t> datagram, const Endpoint& to) noexcept;

  struct Received {
    std::size_t size = 0;  ///< [bytes]; at most the size of the buffer
    Endpoint from;
  };
  /// Receives the next datagram into @p buffer; waits for it at most @p wait [ns]. A longer
  /// datagram is truncated. To detect that, the caller makes @p buffer one byte larger than the
  /// longest valid datagram.
  std::optional<Received> receive(std::span<std::uint8_t> buffer, std::int64_t wait = 0) noexcept;

  /// The address that the socket is bound to, with the port that the system assigned.
  const Endpoint& local() const noexcept { return local_; }

 private:
  int descriptor_;
  Endpoint local_;
};

}  // namespace haptics::devices
