#pragma once

#include <atomic>
#include <cstddef>
#include <string>
#include <thread>

namespace tests {

/// A line between a station and a server, which can be cut, stopped and slowed: a port of this
/// computer, and a thread that carries bytes to a Unix socket and back.
class Line {
 public:
  /// @param socket  of the server
  explicit Line(std::string socket);
  ~Line();
  Line(const Line&) = delete;
  Line& operator=(const Line&) = delete;

  /// To reach the server over this line. Without encryption, so that bytes can be counted.
  std::string server(const std::string& database) const;

  enum class Fault {
    None,
    Cut,   ///< both ends are told
    Stop,  ///< nobody is told: nothing arrives any more
    Slow   ///< a tenth of a millisecond for each of 100 bytes, as 8 Mbit/s
  };
  /// Of each connection that is made from now on, as soon as it has carried @p bytes (both ways).
  void set(Fault fault, std::size_t bytes = 0);

  /// How much the last connection carried.
  std::size_t carried() const noexcept { return carried_; }

 private:
  void run();
  void carry(int station, int server);

  std::string socket_;
  int listener_ = -1;
  int port_ = 0;
  std::atomic<Fault> fault_{Fault::None};
  std::atomic<std::size_t> limit_{0};
  std::atomic<std::size_t> carried_{0};
  std::atomic<bool> isOver_{false};
  std::thread thread_;
};

}  // namespace tests
