#include "tests/study/collect/line.h"

#include <arpa/inet.h>
#include <poll.h>
#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <stdexcept>
#include <utility>

#include <fmt/format.h>

namespace tests {
namespace {

constexpr int kBetweenLooks = 20;  // [ms]

bool canRead(int socket) {
  pollfd one{.fd = socket, .events = POLLIN, .revents = 0};
  return poll(&one, 1, kBetweenLooks) > 0;
}

bool sendAll(int socket, const char* bytes, std::size_t count) {
  while (count > 0) {
    const auto sent = send(socket, bytes, count, MSG_NOSIGNAL);
    if (sent <= 0) return false;
    bytes += sent;
    count -= static_cast<std::size_t>(sent);
  }
  return true;
}

int connected(const std::string& path) {
  const int server = socket(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path.copy(address.sun_path, sizeof address.sun_path - 1);
  if (connect(server, reinterpret_cast<sockaddr*>(&address), sizeof address) == 0) return server;
  close(server);
  return -1;
}

}  // namespace

Line::Line(std::string socket)
    : socket_(std::move(socket)), listener_(::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0)) {
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  auto* plain = reinterpret_cast<sockaddr*>(&address);
  if (bind(listener_, plain, size) != 0 || listen(listener_, 5) != 0 ||
      getsockname(listener_, plain, &size) != 0) {
    throw std::runtime_error("no port");
  }
  port_ = ntohs(address.sin_port);
  thread_ = std::thread([this] { run(); });
}

Line::~Line() {
  isOver_ = true;
  thread_.join();
  close(listener_);
}

std::string Line::server(const std::string& database) const {
  return fmt::format(
      "host=127.0.0.1 port={} dbname={} sslmode=disable gssencmode=disable", port_, database);
}

void Line::set(Fault fault, std::size_t bytes) {
  limit_ = bytes;
  fault_ = fault;
}

void Line::run() {
  while (!isOver_) {
    if (!canRead(listener_)) continue;
    const int station = accept4(listener_, nullptr, nullptr, SOCK_CLOEXEC);
    const int server = connected(socket_);
    if (station >= 0 && server >= 0) carry(station, server);
    close(server);
    close(station);
  }
}

void Line::carry(int station, int server) {
  const auto fault = fault_.load();
  const auto limit = limit_.load();
  carried_ = 0;
  std::array<char, 4096> some{};
  std::array<pollfd, 2> ends{};
  while (!isOver_) {
    const bool isThere = carried_ >= limit;
    if (fault == Fault::Cut && isThere) return;
    const bool isStopped = fault == Fault::Stop && isThere;
    // Whoever stops listening is noticed also where nothing is carried.
    const auto events = static_cast<short>(isStopped ? POLLRDHUP : POLLIN);
    ends = {pollfd{station, events, 0}, pollfd{server, events, 0}};
    if (poll(ends.data(), ends.size(), kBetweenLooks) <= 0) continue;
    if (isStopped) return;
    for (const auto& end : ends) {
      if (end.revents == 0) continue;
      std::size_t most = some.size();
      if (fault == Fault::Cut || fault == Fault::Stop) most = std::min(most, limit - carried_);
      if (fault == Fault::Slow) most = std::size_t{100};
      if (most == 0) break;
      const auto count = recv(end.fd, some.data(), most, 0);
      if (count <= 0) return;
      if (fault == Fault::Slow) std::this_thread::sleep_for(std::chrono::microseconds(100));
      const auto bytes = static_cast<std::size_t>(count);
      if (!sendAll(end.fd == station ? server : station, some.data(), bytes)) return;
      carried_ += bytes;
    }
  }
}

}  // namespace tests
