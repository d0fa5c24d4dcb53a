#pragma once

#include <chrono>
#include <cstdint>

#include "study/collect/server/connection.h"

namespace study::bench {

/// How long something took, and how much time of a processor this process and the server's process
/// for one connection used for it [s]. The processor time hardly depends on other work of the
/// computer, and does not include waiting for the disk.
struct WorkTime {
  double wall = 0.0;
  double processor = 0.0;

  WorkTime& operator+=(const WorkTime& other) {
    wall += other.wall;
    processor += other.processor;
    return *this;
  }
};

class WorkWatch {
 public:
  explicit WorkWatch(collect::Connection& server);

  void start();
  WorkTime elapsed() const;

 private:
  double processorSeconds() const;

  std::int64_t process_;
  std::chrono::steady_clock::time_point wall_;
  double processor_ = 0.0;
};

template <typename Action>
WorkTime timeOf(collect::Connection& server, const Action& action) {
  const WorkWatch watch(server);
  action();
  return watch.elapsed();
}

}  // namespace study::bench
