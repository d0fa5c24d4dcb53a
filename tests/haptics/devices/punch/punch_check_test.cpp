// Whether a punch can be opened, and what its check finds.
#include <fcntl.h>
#include <sys/ioctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <memory>
#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/devices/punch/punch_kind.h"
#include "tests/haptics/devices/punch/emulated_punch.h"

namespace haptics::devices {
namespace punch_check_test {

using namespace emulated_punch;

class PunchCheckTest : public EmulatedPunch {};

TEST_F(PunchCheckTest, NamesTheReasonWhenItCannotBeOpened) {
  EXPECT_TRUE(
      says(whyNot([&] { PunchDevice(settings(folder_ / "nobody")).open(); }), "no serial port"));
  const auto file = folder_.write("file", "no line");
  EXPECT_TRUE(says(whyNot([&] { PunchDevice(settings(file)).open(); }), "is no serial port"));
  emulators::PseudoTerminal nobody;
  EXPECT_TRUE(
      says(whyNot([&] { PunchDevice(settings(nobody.port())).open(); }), "does not answer"));
  auto odd = settings(nobody.port());
  odd.baud = 12345;
  EXPECT_TRUE(says(whyNot([&] { PunchDevice(odd).open(); }), "12345 baud"));
}

TEST_F(PunchCheckTest, RefusesAnotherFirmware) {
  auto options = atRest();
  options.limits.build = 0xABCDEF;
  connect(options);
  EXPECT_TRUE(says(whyNot([&] { device_->open(); }), "runs firmware 0000000000abcdef"));
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Closed);
  auto meant = settings(board_->port());
  meant.build = 0xABCDEF;
  PunchDevice device(meant);
  EXPECT_EQ(whyNot([&] { device.open(); }), "");
}

TEST_F(PunchCheckTest, RefusesAnotherBoard) {
  auto options = atRest();
  options.limits.serial = 12;
  connect(options);
  auto other = settings(board_->port());
  other.serial = 13;
  EXPECT_TRUE(says(whyNot([&] { PunchDevice(other).open(); }), "is board 12, and board 13"));
  other.serial = 12;
  EXPECT_EQ(whyNot([&] { PunchDevice(other).open(); }), "");
}

/// Answers everything with one and the same greeting.
class Stranger {
 public:
  explicit Stranger(const wire::punch::Hello& hello)
      : thread_([this, hello](const std::stop_token& stop) {
          std::array<std::uint8_t, 256> heard{};
          std::array<std::uint8_t, wire::punch::kLargestOnWire> bytes{};
          const auto count = wire::punch::encode(hello, 0, 0, bytes.data());
          while (!stop.stop_requested()) {
            if (line_.read(heard) > 0) line_.write(std::span(bytes).first(count));
            timing::sleepUntil(soon(kMillisecond));
          }
        }) {}
  const std::string& port() const { return line_.port(); }

 private:
  emulators::PseudoTerminal line_;
  std::jthread thread_;
};

TEST_F(PunchCheckTest, RefusesAnotherProtocol) {
  const Stranger newer({.protocolVersion = 9, .build = kFirmwareBuild, .rate = 1000});
  EXPECT_TRUE(says(
      whyNot([&] { PunchDevice(settings(newer.port())).open(); }), "version 9 of the protocol"));
}

TEST_F(PunchCheckTest, RefusesABoardThatCannotBe) {
  const Stranger broken({.build = kFirmwareBuild, .rate = 1});
  EXPECT_TRUE(says(whyNot([&] { PunchDevice(settings(broken.port())).open(); }), "what cannot be"));
}

TEST_F(PunchCheckTest, RefusesALineThatIsInUse) {
  connect(atRest());
  device_->open();
  PunchDevice second(settings(board_->port()));
  EXPECT_TRUE(says(whyNot([&] { second.open(); }), "in use by another program"));
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Open);
  device_->close();
  EXPECT_EQ(whyNot([&] { second.open(); }), "");
}

TEST_F(PunchCheckTest, LeavesTheLineExclusiveThatItMayNotUse) {
  connect(atRest());
  // Opened before, so that it can ask without the right to open an exclusive line.
  const int observer = ::open(board_->port().c_str(), O_RDONLY | O_NOCTTY | O_NONBLOCK);
  ASSERT_GE(observer, 0);
  device_->open();
  PunchDevice second(settings(board_->port()));
  EXPECT_NE(whyNot([&] { second.open(); }), "");
  int isExclusive = 0;
  EXPECT_EQ(ioctl(observer, TIOCGEXCL, &isExclusive), 0);
  EXPECT_EQ(isExclusive, 1);
  ::close(observer);
}

TEST_F(PunchCheckTest, UsesLittleProcessorTimeWithoutTicks) {
  connect(atRest());
  device_->open();
  rusage before{};
  rusage after{};
  getrusage(RUSAGE_SELF, &before);
  timing::sleepUntil(soon(500 * kMillisecond));
  getrusage(RUSAGE_SELF, &after);
  const auto used = [](const rusage& usage) {
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           1e-6 * static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec);
  };
  EXPECT_LT(used(after) - used(before), 0.25);
}

bool isFit(const std::vector<CheckResult>& found) {
  return std::none_of(found.begin(), found.end(), [](const CheckResult& result) {
    return result.finding == Finding::Fail;
  });
}

TEST_F(PunchCheckTest, PassesItsCheck) {
  connect({});
  std::vector<CheckResult> found;
  const std::int64_t until = soon(kPatience);
  do {
    found = device_->check(0.4);
  } while (!isFit(found) && timing::now() < until);
  for (const auto& line : found) {
    EXPECT_NE(line.finding, Finding::Fail)
        << base::describe(line.what) << ": " << base::describe(line.measured);
    EXPECT_EQ(line.finding == Finding::Pass, line.fix.empty()) << base::describe(line.what);
  }
  for (const char* what : {"firmware", "telemetry", "round trip", "travel", "force at most"}) {
    EXPECT_NE(lineOf(found, what), nullptr) << what;
  }
  const auto* lost = lineOf(found, "frames lost, doubled, late, damaged");
  ASSERT_NE(lost, nullptr);
  EXPECT_EQ(base::describe(lost->measured), "0, 0, 0, 0");
  EXPECT_EQ(lineOf(found, "faults that the board reports")->finding, Finding::Pass);
  EXPECT_EQ(device_->lifecycle(), Lifecycle::Checked);
}

TEST_F(PunchCheckTest, FailsItsCheckWithoutABoard) {
  PunchDevice device(settings(folder_ / "nobody"));
  const auto found = device.check(0.1);
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].finding, Finding::Fail);
  EXPECT_TRUE(says(found[0].fix, "no serial port"));
}

TEST_F(PunchCheckTest, FailsItsCheckWithABrokenDriver) {
  connect(atRest());
  board_->order("driver-fault");
  const auto found = device_->check(0.5);
  const auto* faults = lineOf(found, "faults");
  ASSERT_NE(faults, nullptr);
  EXPECT_EQ(faults->finding, Finding::Fail);
  EXPECT_NE(device_->lifecycle(), Lifecycle::Checked);
}

TEST_F(PunchCheckTest, FailsItsCheckWhenFramesAreLost) {
  connect(atRest());
  const CheckResult* lost = nullptr;
  bool hasPassed = false;
  std::vector<CheckResult> found;
  const std::int64_t until = soon(kPatience);
  while (lost == nullptr && timing::now() < until) {
    const std::jthread spoil([&] {
      timing::sleepUntil(soon(150 * kMillisecond));
      board_->order("drop 20");
    });
    found = device_->check(0.4);
    hasPassed = hasPassed || isFit(found);
    lost = lineOf(found, "frames lost, doubled, late, damaged");
  }
  EXPECT_EQ(device_->lifecycle() == Lifecycle::Checked, hasPassed);
  ASSERT_NE(lost, nullptr);
  EXPECT_EQ(lost->finding, Finding::Fail);
  EXPECT_EQ(base::describe(lost->measured), "20, 0, 0, 0");
  EXPECT_TRUE(says(lost->fix, "cable"));
}

TEST_F(PunchCheckTest, WarnsOfALeapOfThePosition) {
  connect(atRest());
  const CheckResult* leaps = nullptr;
  std::vector<CheckResult> found;
  const std::int64_t until = soon(kPatience);
  while ((leaps == nullptr || leaps->finding != Finding::Warn) && timing::now() < until) {
    const std::jthread spoil([&] {
      timing::sleepUntil(soon(150 * kMillisecond));
      board_->order("leap 100");
    });
    found = device_->check(0.4);
    leaps = lineOf(found, "leaps of the position");
  }
  ASSERT_NE(leaps, nullptr);
  EXPECT_EQ(leaps->finding, Finding::Warn);
  EXPECT_EQ(base::describe(leaps->measured), "1");
  EXPECT_TRUE(says(leaps->fix, "cable"));
}

}  // namespace punch_check_test
}  // namespace haptics::devices
