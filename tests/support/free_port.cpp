#include "tests/support/free_port.h"

#include <netinet/in.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <stdexcept>

namespace tests {
namespace {

constexpr unsigned kFirst = 12000;
constexpr unsigned kPorts = 20000;
constexpr unsigned kStep = 37;  // no divisor of kPorts: every port is tried

bool isFree(std::uint16_t port, int type) {
  const int listener = socket(AF_INET, type | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  address.sin_port = htons(port);
  const bool isBound =
      bind(listener, reinterpret_cast<const sockaddr*>(&address), sizeof address) == 0;
  close(listener);
  return isBound;
}

}  // namespace

std::uint16_t freePort() {
  static std::atomic<unsigned> next{static_cast<unsigned>(getpid()) * 101U};
  for (unsigned tried = 0; tried < kPorts; ++tried) {
    const auto port = static_cast<std::uint16_t>(kFirst + next.fetch_add(kStep) % kPorts);
    if (isFree(port, SOCK_DGRAM) && isFree(port, SOCK_STREAM)) return port;
  }
  throw std::runtime_error("No port of 127.0.0.1 from 12000 to 31999 is free.");
}

}  // namespace tests
