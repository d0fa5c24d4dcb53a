#include "haptics/devices/datagram_socket.h"

#include <arpa/inet.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <charconv>
#include <system_error>
#include <utility>

#include "haptics/timing/monotonic_clock.h"

namespace haptics::devices {
namespace {

sockaddr_in nativeOf(const Endpoint& endpoint) noexcept {
  sockaddr_in native{};
  native.sin_family = AF_INET;
  native.sin_addr.s_addr = htonl(endpoint.address);
  native.sin_port = htons(endpoint.port);
  return native;
}

Endpoint endpointOf(const sockaddr_in& native) noexcept {
  return {.address = ntohl(native.sin_addr.s_addr), .port = ntohs(native.sin_port)};
}

/// Casts to the generic address type that the socket functions expect.
const sockaddr* asSockaddr(const sockaddr_in& address) noexcept {
  return reinterpret_cast<const sockaddr*>(&address);
}
sockaddr* asSockaddr(sockaddr_in& address) noexcept {
  return reinterpret_cast<sockaddr*>(&address);
}

[[noreturn]] void refuse(const Endpoint& endpoint, int error) {
  throw NetworkError(
      "cannot listen on " + endpoint.text() + ": " + std::generic_category().message(error));
}

std::optional<std::uint16_t> portFrom(std::string_view text) {
  std::uint16_t port = 0;
  const char* end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, port);
  if (error != std::errc{} || stop != end) return std::nullopt;
  return port;
}

bool waitFor(int descriptor, std::int64_t wait) noexcept {
  pollfd awaited{.fd = descriptor, .events = POLLIN, .revents = 0};
  const timespec time{.tv_sec = wait / timing::kSecond, .tv_nsec = wait % timing::kSecond};
  return ppoll(&awaited, 1, &time, nullptr) > 0;
}

}  // namespace

std::string Endpoint::text() const {
  std::string text;
  for (int shift = 24; shift >= 0; shift -= 8) {
    text += std::to_string(address >> static_cast<unsigned>(shift) & 0xFFU);
    text += shift > 0 ? '.' : ':';
  }
  return text + std::to_string(port);
}

std::optional<Endpoint> endpointFrom(std::string_view text, std::uint16_t port) {
  const auto colon = text.find(':');
  if (colon != std::string_view::npos) {
    const auto read = portFrom(text.substr(colon + 1));
    if (!read) return std::nullopt;
    port = *read;
  }
  in_addr address{};
  if (inet_pton(AF_INET, std::string(text.substr(0, colon)).c_str(), &address) != 1) {
    return std::nullopt;
  }
  return Endpoint{.address = ntohl(address.s_addr), .port = port};
}

DatagramSocket::DatagramSocket(const Endpoint& local)
    : descriptor_(socket(AF_INET, SOCK_DGRAM | SOCK_CLOEXEC | SOCK_NONBLOCK, 0)) {
  if (descriptor_ < 0) refuse(local, errno);
  sockaddr_in address = nativeOf(local);
  socklen_t size = sizeof(address);
  const bool isThere = bind(descriptor_, asSockaddr(std::as_const(address)), size) == 0 &&
                       getsockname(descriptor_, asSockaddr(address), &size) == 0;
  if (!isThere) {
    const int error = errno;
    close(descriptor_);
    refuse(local, error);
  }
  local_ = endpointOf(address);
}

DatagramSocket::~DatagramSocket() {
  close(descriptor_);
}

bool DatagramSocket::send(std::span<const std::uint8_t> datagram, const Endpoint& to) noexcept {
  const sockaddr_in address = nativeOf(to);
  const auto sent = sendto(
      descriptor_, datagram.data(), datagram.size(), 0, asSockaddr(address), sizeof(address));
  return sent == static_cast<ssize_t>(datagram.size());
}

std::optional<DatagramSocket::Received> DatagramSocket::receive(
    std::span<std::uint8_t> buffer, std::int64_t wait) noexcept {
  if (wait > 0 && !waitFor(descriptor_, wait)) return std::nullopt;
  sockaddr_in from{};
  socklen_t size = sizeof(from);
  const auto got = recvfrom(descriptor_, buffer.data(), buffer.size(), 0, asSockaddr(from), &size);
  if (got < 0) return std::nullopt;
  return Received{.size = static_cast<std::size_t>(got), .from = endpointOf(from)};
}

}  // namespace haptics::devices
