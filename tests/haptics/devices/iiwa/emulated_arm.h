#pragma once

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <future>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/iiwa_device.h"
#include "haptics/emulators/fri_controller.h"
#include "tests/haptics/devices/device_expectations.h"
#include "tests/support/free_port.h"

/// An arm over FRI against the emulated controller. Periods of the controller go by when the test
/// says so, and by its own clock, so that what is counted does not depend on how busy this computer
/// is.
namespace haptics::devices::emulated_arm {

using namespace haptics::wire::fri;
using emulators::FriController;
using emulators::FriReport;
using timing::kMillisecond;
using timing::kSecond;

inline constexpr int kPeriod = 2;  ///< [ms]

inline std::atomic<std::int64_t> controllerTime{kSecond};
inline std::int64_t controllerClock() noexcept {
  return controllerTime.load();
}

inline Joints startOfArm() {
  return emulators::FriArm::Options{}.start;
}

/// Down, as the emulated arm's tool points.
inline const Eigen::Vector3d kDown{0.0, 0.0, -1.0};

inline IiwaSettings settings(Version version = Version::V1_15, IiwaOverlay overlay = {}) {
  IiwaSettings made;
  made.port = tests::freePort();
  made.version = version;
  made.overlay = overlay;
  made.tool.position.z() = 0.2;
  made.zero = startOfArm();
  return made;
}

inline FriController::Options controllerFor(const IiwaSettings& settings) {
  FriController::Options options;
  options.version = settings.version;
  options.client.port = settings.port;
  options.sendPeriod = kPeriod;
  options.dwellTimes = {.idle = 3, .monitoringReady = 5, .commandingWait = 3};
  options.restartsMotion = true;
  options.clock = controllerClock;
  options.arm.person = {.closed = 0.0, .stiffness = 2000.0, .damping = 60.0};
  if (settings.overlay == IiwaOverlay::JointTorque) {
    options.arm.control = ControlMode::JointImpedance;
    options.arm.command = ClientCommandMode::Torque;
  }
  return options;
}

/// A controller whose periods go by when the test says so, and the device that it speaks to.
class EmulatedArm : public testing::Test {
 protected:
  void connect(const IiwaSettings& settings) { connect(settings, controllerFor(settings)); }
  void connect(const IiwaSettings& settings, const FriController::Options& options) {
    device_ = std::make_unique<IiwaDevice>(settings);
    controller_ = std::make_unique<FriController>(options);
  }

  FriReport report() const { return controller_->report(); }
  void order(const std::string& line) {
    const auto reply = controller_->command(line);
    EXPECT_TRUE(reply.isAccepted) << reply.text;
  }

  void period() {
    controllerTime += controller_->options().sendPeriod * kMillisecond;
    controller_->step();
  }
  void hear() {
    while (controller_->receive(controllerClock())) {
    }
  }

  /// Lets the device do something that takes messages, and gives them as fast as they are answered.
  void during(const std::function<void()>& action) {
    auto done = std::async(std::launch::async, action);
    const auto isDone = [&] {
      return done.wait_for(std::chrono::seconds(0)) == std::future_status::ready;
    };
    while (!isDone()) {
      const auto answered = report().answers.taken;
      period();
      timing::sleepUntil(soon(kMillisecond / 4));
      const bool isDue = report().state != emulators::FriSession::State::Idle;
      const std::int64_t until = soon(50 * kMillisecond);
      while (isDue && report().answers.taken == answered && timing::now() < until && !isDone()) {
        controller_->receive(controllerClock() + kMillisecond);
      }
    }
    done.get();
  }
  void openAndArm() {
    during([this] { device_->open(); });
    during([this] { device_->arm(); });
    answer(0.0);  // what was left over
  }

  /// One period and the device's answer to it.
  DeviceSample turn(double force, double torque = 0.0) {
    period();
    return answer(force, torque);
  }
  DeviceSample answer(double force, double torque = 0.0) {
    device_->pacer()->wait(soon(kMillisecond));
    const auto sample = device_->read(0.001 * kPeriod);
    device_->command(force, torque);
    hear();
    return sample;
  }
  void turns(double force, int count, double torque = 0.0) {
    for (int i = 0; i < count; ++i) turn(force, torque);
  }
  bool isFaulted() const { return device_->lifecycle() == Lifecycle::Faulted; }
  /// Ticks on until it is over; the last sample.
  DeviceSample turnUntilFault(double force) {
    DeviceSample sample;
    for (int i = 0; i < 1000 && !isFaulted(); ++i) sample = turn(force);
    EXPECT_TRUE(isFaulted());
    return sample;
  }
  /// At work.
  void work(double force, int count = 30) {
    openAndArm();
    turns(force, count);
    ASSERT_FALSE(isFaulted()) << base::describe(device_->fault());
    ASSERT_NEAR(report().force, -force, 0.5);
  }

  std::unique_ptr<IiwaDevice> device_;
  std::unique_ptr<FriController> controller_;
};

struct Session {
  Version version;
  IiwaOverlay overlay;
};

}  // namespace haptics::devices::emulated_arm
