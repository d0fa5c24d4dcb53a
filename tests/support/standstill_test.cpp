// The judge of tests that depend on real time: what it measures, and what it makes of that.
#include "tests/support/standstill.h"

#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <thread>

#include <gtest/gtest.h>

#include "haptics/timing/standstill_watch.h"

namespace tests {
namespace standstill_test {

using namespace std::chrono_literals;

TEST(Standstill, TurnsAFailureIntoASkippedTestAndNothingElse) {
  EXPECT_EQ(judged(0, 0ms), 0);
  EXPECT_EQ(judged(0, 1000ms), 0);
  EXPECT_EQ(judged(1, 0ms), 1);
  EXPECT_EQ(judged(1, 4ms), 1);
  EXPECT_EQ(judged(1, 5ms), kMachineStoodStill);
}

TEST(StandstillWatch, NoticesThatTheProcessWasStopped) {
  const haptics::timing::StandstillWatch watch;
  const pid_t stopped = getpid();
  const pid_t helper = fork();
  if (helper == 0) {  // only what may follow a fork among threads
    usleep(10'000);
    kill(stopped, SIGSTOP);
    usleep(60'000);
    kill(stopped, SIGCONT);
    _exit(0);
  }
  ASSERT_GT(helper, 0);
  waitpid(helper, nullptr, 0);
  for (int i = 0; i < 10'000 && watch.longest() < 50ms; ++i) std::this_thread::sleep_for(1ms);
  EXPECT_GE(watch.longest(), 50ms);
}

}  // namespace standstill_test
}  // namespace tests
