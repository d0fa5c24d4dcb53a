// Devices that lie. Whatever one reports, what it is told to do to a hand is finite, within the
// limits of force, torque and their rates, and nothing at all once it is gone.
//
// The control is the same device with the same scene and no limits between them: it has to be told
// something unsafe, or the attack shows nothing.
#include <algorithm>
#include <cmath>
#include <functional>
#include <limits>
#include <ostream>
#include <string>

#include <gtest/gtest.h>

#include "base/random.h"
#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/devices/simulated_device.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/engine/force_engine.h"

namespace haptics::engine {
namespace hostile_devices_test {

using devices::DeviceSample;
using devices::DeviceStatus;

constexpr double kDt = 0.001;
constexpr int kTicks = 4'000;
constexpr int kFirstLie = 700;  // until then it is honest, so that a force has come on
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();
constexpr double kRounding = 1e-9;  // of a rate times a period

/// Spoils an honest sample. @p tick counts from the first lie; @p most is the device's travel.
using Lie =
    std::function<void(DeviceSample& sample, int tick, double most, base::SplitMix64& random)>;

struct Attack {
  const char* name;
  Lie lie;
  bool isTheLast = false;          ///< there is no measurement any more
  bool isTheClockBad = false;      ///< and periods are missed
  bool isRefusedByScenes = false;  ///< they answer with no force by themselves
};
std::ostream& operator<<(std::ostream& out, const Attack& attack) {
  return out << attack.name;
}

const Attack kAttacks[] = {
    {"Silent", [](auto& s, int, double, auto&) { s.status = DeviceStatus::NotAnswering; }, true},
    {"Stale", [](auto& s, int, double, auto&) { s.status = DeviceStatus::Stale; }, true},
    {"Faulted", [](auto& s, int, double, auto&) { s.status = DeviceStatus::Faulted; }, true},
    {"EveryFortyFifthSample",
     [](auto& s, int t, double, auto&) {
       s.status = t % 45 == 0 ? DeviceStatus::Ok : DeviceStatus::Stale;
     }},
    {"Leap", [](auto& s, int t, double most, auto&) { s.travel = t % 500 < 250 ? 0.0 : most; }},
    {"Alternating", [](auto& s, int t, double most, auto&) { s.travel = t % 2 == 0 ? 0.0 : most; }},
    {"Noise", [](auto& s, int, double most, auto& random) { s.travel = most * random.uniform(); }},
    {"HugePosition", [](auto& s, int, double, auto&) { s.travel = 1e300; }},
    {"HugePositionBehindRest",
     [](auto& s, int, double, auto&) { s.travel = -1e300; },
     false,
     false,
     true},
    {"NoNumber", [](auto& s, int, double, auto&) { s.travel = kNaN; }, false, false, true},
    {"Infinite",
     [](auto& s, int t, double, auto&) { s.travel = t % 2 == 0 ? kInfinity : -kInfinity; },
     false,
     false,
     true},
    {"VelocityIsNoNumber", [](auto& s, int, double, auto&) { s.velocity = kNaN; }},
    {"HugeVelocity",
     [](auto& s, int t, double, auto&) { s.velocity = t % 2 == 0 ? 1e300 : -1e300; }},
    {"FlickeringSwitches",
     [](auto& s, int t, double most, auto&) {
       s.isDeadManHeld = t % 3 != 0;
       s.isReamerOn = t % 5 != 0;
       s.travel = t % 7 < 3 ? 0.0 : most;
     }},
    {"AllAtOnce",
     [](auto& s, int, double most, auto& random) {
       const double values[] = {0.0, most, -most, 1e300, kNaN, kInfinity, most * random.uniform()};
       const auto any = [&] { return values[random.bits() % std::size(values)]; };
       s = {
           .status = static_cast<DeviceStatus>(random.bits() % 4),
           .travel = any(),
           .velocity = any(),
           .turn = any(),
           .isDeadManHeld = random.bits() % 2 == 0,
           .isReamerOn = random.bits() % 2 == 0};
     },
     false,
     true},
};

struct Setting {
  devices::Capabilities capabilities;
  SceneSpec scene;
  SafetyLimits limits;
};

SceneSpec stiffElements() {
  FiniteElementsSpec spec = publishedElements(100);
  spec.parameters.elementStiffness *= 1e6;
  return {.model = spec};
}
SceneSpec reaming() {
  MaterialSpec spec;
  spec.curves = parametricCurves();
  spec.torque = parametricTorque();
  spec.hardness = 1.0;
  spec.isRemoved = true;
  return {.model = spec};
}

Setting settingOf(const std::string& name) {
  const SafetyLimits small{.maxForce = 3.0, .maxRate = 300.0};
  const SafetyLimits large{
      .maxForce = 20.0, .maxRate = 500.0, .maxTorque = 1.0, .maxTorqueRate = 20.0};
  const auto punch = devices::simulated(devices::punchKind());
  if (name == "Interpolation") return {punch, {.model = publishedInterpolation()}, small};
  if (name == "StiffElements") return {punch, stiffElements(), small};
  if (name == "Kalman") {
    return {punch, {.model = publishedFilter(models::KalmanScheme::AuthorsFirmware, 20)}, small};
  }
  return {devices::simulated(devices::reamerKind()), reaming(), large};
}
const char* const kScenes[] = {"Interpolation", "StiffElements", "Kalman", "Reaming"};

/// Moves honestly for a while, then lies; keeps what it is told.
class HostileDevice final : public devices::Device {
 public:
  HostileDevice(devices::Capabilities capabilities, const Attack& attack)
      : capabilities_(std::move(capabilities)), attack_(attack) {}

  const devices::Capabilities& capabilities() const noexcept override { return capabilities_; }
  DeviceSample read(double dt) noexcept override {
    const double most = capabilities_.largestTravel;
    // Slowly in and out, in two seconds.
    const double phase = std::fmod(tick_ * dt, 2.0);
    const double travel = most * (phase < 1.0 ? phase : 2.0 - phase);
    DeviceSample sample{
        .status = DeviceStatus::Ok, .travel = travel, .velocity = (travel - last_) / dt};
    last_ = travel;
    if (tick_ >= kFirstLie) attack_.lie(sample, tick_ - kFirstLie, most, random_);
    ++tick_;
    return sample;
  }
  void command(double force, double torque) noexcept override {
    this->force = force;
    this->torque = torque;
  }

  double force = 0.0;
  double torque = 0.0;

 private:
  devices::Capabilities capabilities_;
  const Attack& attack_;
  base::SplitMix64 random_{20260101};
  int tick_ = 0;
  double last_ = 0.0;
};

/// Finds what a hand must not be given.
class Judge {
 public:
  Judge(const SafetyLimits& limits, const Attack& attack) : limits_(limits), attack_(attack) {}

  /// Of the next tick; empty where it is safe.
  std::string wrongWith(double force, double torque) {
    const bool isGone =
        attack_.isTheLast && tick_ >= kFirstLie + std::lround(limits_.longestSilence / kDt);
    std::string wrong;
    if (isGone && (force != 0.0 || torque != 0.0)) wrong = "not let go";
    if (isUnsafe(force, force_, limits_.maxForce, limits_.maxRate)) wrong = "force";
    if (isUnsafe(torque, torque_, limits_.maxTorque, limits_.maxTorqueRate)) wrong = "torque";
    force_ = force;
    torque_ = torque;
    ++tick_;
    return wrong;
  }

 private:
  static bool isUnsafe(double now, double before, double most, double rate) {
    const bool isLettingGo = now == 0.0;  // at once, where something is wrong
    return !std::isfinite(now) || std::abs(now) > most + kRounding ||
           (!isLettingGo && std::abs(now - before) > rate * kDt + kRounding);
  }

  SafetyLimits limits_;
  const Attack& attack_;
  double force_ = 0.0;
  double torque_ = 0.0;
  int tick_ = 0;
};

class HostileDevices : public testing::TestWithParam<Attack> {};

TEST_P(HostileDevices, AreNeverToldAnUnsafeForce) {
  for (const std::string name : kScenes) {
    SCOPED_TRACE(name);
    const Setting setting = settingOf(name);
    HostileDevice device(setting.capabilities, GetParam());
    ForceEngine engine(device, setting.limits);
    CompiledScene scene(setting.scene);
    engine.setScene(&scene);
    Judge judge(setting.limits, GetParam());
    double felt = 0.0;
    for (int tick = 0; tick < kTicks; ++tick) {
      const int missed = GetParam().isTheClockBad ? tick % 4 : 0;
      engine.tick(kDt, missed);
      ASSERT_EQ(judge.wrongWith(device.force, device.torque), "")
          << "tick " << tick << ": " << device.force << " N, " << device.torque << " N·m";
      if (tick < kFirstLie) felt = std::max(felt, std::abs(device.force));
    }
    EXPECT_GT(felt, 0.1 * setting.limits.maxForce) << "there was nothing to lose";
  }
}

/// The control: the device's word goes to the scene, and the scene's answer to the hand.
TEST_P(HostileDevices, AreDangerousWithoutAnEngine) {
  std::string found;
  for (const std::string name : kScenes) {
    if (name == "StiffElements") continue;  // too steep for an honest hand
    const Setting setting = settingOf(name);
    HostileDevice device(setting.capabilities, GetParam());
    CompiledScene scene(setting.scene);
    Judge judge(setting.limits, GetParam());
    for (int tick = 0; tick < kTicks && found.empty(); ++tick) {
      const auto sample = device.read(kDt);
      const auto answer =
          scene.respond({.travel = sample.travel, .velocity = sample.velocity, .dt = kDt});
      const std::string wrong = judge.wrongWith(answer.force, scene.torque());
      if (tick >= kFirstLie) found = wrong;
    }
  }
  EXPECT_EQ(found.empty(), GetParam().isRefusedByScenes) << found;
}

INSTANTIATE_TEST_SUITE_P(Of, HostileDevices, testing::ValuesIn(kAttacks), [](const auto& test) {
  return std::string(test.param.name);
});

}  // namespace hostile_devices_test
}  // namespace haptics::engine
