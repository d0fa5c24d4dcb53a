#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include <gtest/gtest.h>

#include "haptics/emulators/fri_controller.h"
#include "tests/haptics/emulators/answering_client.h"

namespace tests {

using haptics::emulators::FriController;
using haptics::emulators::FriReport;
using haptics::wire::fri::ClientCommandMode;
using haptics::wire::fri::ControlMode;

inline constexpr std::int64_t kPatience =
    5'000'000'000;  // for what is on its way on this machine [ns]

/// A clock that stands still until a test moves it [ns].
inline std::int64_t& time() {
  static std::int64_t now = 1'000'000'000;
  return now;
}
inline std::int64_t testTime() noexcept {
  return time();
}

/// A controller, a client, and periods that go by when the test says so. Whatever is sent is
/// awaited, so nothing depends on timing.
class SteppedSession {
 public:
  explicit SteppedSession(FriController::Options options = {}) : client(options.version) {
    options.client = client.endpoint();
    options.clock = testTime;
    controller.emplace(options);
    client.expect(controller->local());
    client.every = static_cast<std::uint32_t>(options.receiveMultiplier);
    if (options.arm.command == ClientCommandMode::Wrench)
      client.wrench = haptics::wire::fri::Vector6{};
    if (options.arm.command == ClientCommandMode::Torque)
      client.torque = haptics::wire::fri::Joints{};
  }

  void step() {
    time() += controller->options().sendPeriod * 1'000'000LL;
    controller->step();
  }
  void hearAll() {
    const FriReport report = controller->report();
    while (client.seen().datagrams < report.datagrams + report.impostors) {
      ASSERT_TRUE(client.hear(kPatience));
    }
  }
  void overhearAll() {
    const FriReport report = controller->report();
    while (client.seen().datagrams < report.datagrams + report.impostors) {
      ASSERT_TRUE(client.overhear(kPatience));
    }
  }
  /// The controller gets all that the client has sent.
  void receiveAll() {
    for (; received < client.answers(); ++received) {
      ASSERT_TRUE(controller->receive(time() + kPatience));
    }
  }
  /// Periods with an answer to each.
  void go(int periods) {
    for (int i = 0; i < periods; ++i) {
      step();
      hearAll();
      receiveAll();
    }
  }
  void goSilently(int periods) {
    for (int i = 0; i < periods; ++i) {
      step();
      overhearAll();
    }
  }
  bool goTo(haptics::wire::fri::SessionState state, int patience = 1000) {
    for (int i = 0; i < patience && report().state != state; ++i) go(1);
    return report().state == state;
  }
  FriReport report() const { return controller->report(); }
  void order(std::string_view line) {
    const auto reply = controller->command(line);
    EXPECT_TRUE(reply.isAccepted) << reply.text;
  }

  AnsweringClient client;
  std::optional<FriController> controller;
  std::uint64_t received = 0;
};

inline FriController::Options quick(FriController::Options options = {}) {
  options.sendPeriod = 1;
  options.dwellTimes = {.idle = 3, .monitoringReady = 5, .commandingWait = 3};
  return options;
}

inline FriController::Options torque() {
  auto options = quick();
  options.arm.control = ControlMode::JointImpedance;
  options.arm.command = ClientCommandMode::Torque;
  return options;
}

}  // namespace tests
