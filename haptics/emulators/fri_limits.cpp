#include "haptics/emulators/fri_limits.h"

#include <cmath>
#include <cstddef>

namespace haptics::emulators {
namespace {

constexpr double kHair = 1e-9;  // so that rounding at a limit does not decide

int numberOf(std::size_t joint) noexcept {
  return static_cast<int>(joint) + 1;
}

}  // namespace

FriEnd FriJudge::missing(const wire::fri::CommandData& command) const noexcept {
  if (!command.jointPosition) return FriEnd::PositionMissing;
  if (mode_ == Mode::Wrench && !command.wrench) return FriEnd::WrenchMissing;
  if (mode_ == Mode::Torque && !command.jointTorque) return FriEnd::TorqueMissing;
  return FriEnd::None;
}

FriVerdict FriJudge::judge(
    const wire::fri::CommandData& command,
    const wire::fri::Joints& before,
    double seconds) const noexcept {
  const FriEnd lack = missing(command);
  if (lack != FriEnd::None) return {.end = lack};
  const FriVerdict verdict = judgePosition(*command.jointPosition, before, seconds);
  if (verdict.end != FriEnd::None) return verdict;
  if (mode_ == Mode::Wrench) return judgeWrench(*command.wrench);
  if (mode_ == Mode::Torque) return judgeTorque(*command.jointTorque);
  return {};
}

bool FriJudge::isMirror(
    const wire::fri::CommandData& command, const wire::fri::Joints& joints) const noexcept {
  if (missing(command) != FriEnd::None) return false;
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!(std::abs((*command.jointPosition)[i] - joints[i]) <= limits_.mirrorReach)) return false;
  }
  return true;
}

FriVerdict FriJudge::judgePosition(
    const wire::fri::Joints& position,
    const wire::fri::Joints& before,
    double seconds) const noexcept {
  for (std::size_t i = 0; i < position.size(); ++i) {
    if (!(std::abs(position[i]) <= arm_.maxPosition[i] + kHair)) {
      return {.end = FriEnd::PositionLimit, .joint = numberOf(i)};
    }
    if (!(std::abs(position[i] - before[i]) <= arm_.maxVelocity[i] * seconds + kHair)) {
      return {.end = FriEnd::PositionLeap, .joint = numberOf(i)};
    }
  }
  return {};
}

FriVerdict FriJudge::judgeTorque(const wire::fri::Joints& torque) const noexcept {
  for (std::size_t i = 0; i < torque.size(); ++i) {
    if (!(std::abs(torque[i]) <= arm_.maxTorque[i] + kHair)) {
      return {.end = FriEnd::TorqueLimit, .joint = numberOf(i)};
    }
  }
  return {};
}

FriVerdict FriJudge::judgeWrench(const wire::fri::Vector6& wrench) const noexcept {
  const double force = std::hypot(wrench[0], wrench[1], wrench[2]);
  const double moment = std::hypot(wrench[3], wrench[4], wrench[5]);
  const bool isWithin = force <= limits_.maxForce + kHair && moment <= limits_.maxMoment + kHair;
  return {.end = isWithin ? FriEnd::None : FriEnd::WrenchLimit};
}

}  // namespace haptics::emulators
