#include "study/bench/collect/work_time.h"

#include <ctime>
#include <fstream>
#include <string>

#include "haptics/timing/stopwatch.h"

namespace study::bench {

WorkWatch::WorkWatch(collect::Connection& server)
    : process_(server.query("SELECT pg_backend_pid()").number(0, 0)) {
  start();
}

void WorkWatch::start() {
  wall_ = std::chrono::steady_clock::now();
  processor_ = processorSeconds();
}

WorkTime WorkWatch::elapsed() const {
  return {
      .wall = haptics::timing::secondsSince(wall_), .processor = processorSeconds() - processor_};
}

double WorkWatch::processorSeconds() const {
  timespec own{};
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &own);
  // The first number is the time on a processor [ns] (proc(5), schedstat).
  std::ifstream file("/proc/" + std::to_string(process_) + "/schedstat");
  std::int64_t serverTime = 0;
  file >> serverTime;
  return static_cast<double>(own.tv_sec) + 1e-9 * static_cast<double>(own.tv_nsec + serverTime);
}

}  // namespace study::bench
