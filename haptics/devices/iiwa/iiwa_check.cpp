// The check of an arm: IiwaDevice::check().
#include <algorithm>
#include <array>
#include <cmath>

#include "haptics/devices/device.h"
#include "haptics/devices/iiwa/iiwa_device.h"
#include "haptics/timing/monotonic_clock.h"

namespace haptics::devices {
namespace {

using namespace haptics::wire::fri;

constexpr std::array kStateNames{
    "IDLE", "MONITORING_WAIT", "MONITORING_READY", "COMMANDING_WAIT", "COMMANDING_ACTIVE"};
constexpr std::int64_t kLastingSilence = timing::kSecond;
constexpr std::array kQualityNames{"POOR", "FAIR", "GOOD", "EXCELLENT"};

CheckResult sessionFinding(const MonitoringMessage& message) {
  const auto connection = message.connection.value_or(ConnectionInfo{});
  const auto state = static_cast<std::size_t>(connection.state);
  const auto quality = static_cast<std::size_t>(connection.quality);
  const bool isGood = connection.quality >= ConnectionQuality::Good;
  const bool isReady = connection.state >= SessionState::MonitoringReady;
  return {
      !isGood   ? Finding::Fail
      : isReady ? Finding::Pass
                : Finding::Warn,
      deviceMessage("check.session"),
      deviceMessage("check.session.state", kStateNames.at(state), kQualityNames.at(quality)),
      isGood && isReady ? base::Message()
      : isGood          ? deviceMessage("check.session.start")
                        : deviceMessage("check.session.fix")};
}

const char* wordFor(ClientCommandMode mode) noexcept {
  constexpr std::array kWords{"no command", "joint position", "wrench", "torque", "Cartesian pose"};
  return kWords.at(static_cast<std::size_t>(mode));
}

/// Reports that the robot's command mode differs from the device file's, so that the robot never
/// accepts a force.
CheckResult commandModeMismatch(ClientCommandMode mode, ClientCommandMode wanted) {
  const std::string theirs = wordFor(mode);
  const std::string ours = wordFor(wanted);
  const bool canBeOurs = mode == ClientCommandMode::Wrench || mode == ClientCommandMode::Torque;
  return {
      Finding::Fail,
      deviceMessage("check.overlay"),
      deviceMessage("check.overlay.differs", theirs, ours),
      canBeOurs ? deviceMessage("check.overlay.either", theirs, ours)
                : deviceMessage("check.overlay.choose", ours)};
}

CheckResult commandingFinding(
    const MonitoringMessage& message,
    IiwaOverlay overlay,
    std::optional<ClientCommandMode> mode,
    bool hasWaited) {
  const auto wanted =
      overlay == IiwaOverlay::JointTorque ? ClientCommandMode::Torque : ClientCommandMode::Wrench;
  if (mode && *mode != wanted) return commandModeMismatch(*mode, wanted);
  const bool isActive =
      message.connection && message.connection->state == SessionState::CommandingActive;
  const auto what = deviceMessage("check.overlay");
  if (isActive && mode) return {Finding::Pass, what, deviceMessage("check.overlay.active")};
  if (isActive) {
    return {
        Finding::Fail,
        what,
        deviceMessage("check.overlay.unnamed"),
        deviceMessage("check.overlay.choose", wordFor(wanted))};
  }
  if (hasWaited) {
    return {
        Finding::Warn,
        what,
        deviceMessage("check.overlay.waits"),
        deviceMessage("check.overlay.start_or_choose")};
  }
  return {
      Finding::Warn,
      what,
      deviceMessage("check.overlay.not_yet"),
      deviceMessage("check.overlay.start")};
}

/// Reports the longest time [ns] without a message. A trial ends after @p limit [ns]; a short
/// excess may come from a busy computer and is only a warning.
CheckResult silenceFinding(std::int64_t longest, bool isLasting, std::int64_t limit) {
  constexpr std::int64_t kLongestExcusedSilence = timing::kSecond / 2;
  const double seconds = 1e-9 * static_cast<double>(longest);
  const double limitMs = 1e-6 * static_cast<double>(limit);
  const auto what = deviceMessage("check.silence");
  if (longest <= limit) {
    return {Finding::Pass, what, deviceMessage("check.silence.short", 1e3 * seconds)};
  }
  if (isLasting) {
    return {
        Finding::Fail,
        what,
        deviceMessage("check.silence.lasting", seconds, limitMs),
        deviceMessage("check.silence.lasting.fix")};
  }
  return {
      longest > kLongestExcusedSilence ? Finding::Fail : Finding::Warn,
      what,
      deviceMessage("check.silence.long", seconds, limitMs),
      deviceMessage("check.silence.long.fix")};
}

CheckResult safetyFinding(const MonitoringMessage& message) {
  const auto info = message.robotInfo.value_or(RobotInfo{});
  const bool isNormal =
      info.safetyState.value_or(SafetyState::NormalOperation) == SafetyState::NormalOperation;
  return passIf(
      isNormal,
      Finding::Fail,
      deviceMessage("check.safety"),
      isNormal ? deviceMessage("check.safety.normal") : deviceMessage("check.safety.stop"),
      deviceMessage("check.safety.fix"));
}

CheckResult cycleFinding(const LinkReport& link, double seconds, double rate) {
  const double seen = static_cast<double>(link.received) / seconds;
  return passIf(
      std::abs(seen / rate - 1.0) < 0.05,
      Finding::Warn,
      deviceMessage("check.cycle"),
      deviceMessage("check.cycle.rate", seen, rate),
      deviceMessage("check.cycle.fix"));
}

CheckResult anomalyFinding(const LinkReport& link) {
  const auto bad = link.lost + link.doubled + link.late + link.damaged + link.foreign;
  return passIf(
      bad == 0,
      Finding::Warn,
      deviceMessage("check.messages"),
      deviceMessage(
          "check.messages.counts", link.lost, link.doubled, link.late, link.damaged, link.foreign),
      deviceMessage("check.messages.fix"));
}

CheckResult torqueFinding(const Capabilities& capabilities) {
  return {
      Finding::Pass,
      deviceMessage("check.torque"),
      capabilities.rendersTorque()
          ? deviceMessage("check.torque.newton_metres", capabilities.maxTorque)
          : deviceMessage("check.torque.none")};
}

}  // namespace

IiwaDevice::ListenResult IiwaDevice::listen(double seconds) {
  resetCounts();
  sequence_ = {};
  ListenResult listening;
  const std::int64_t begin = timing::now();
  const std::int64_t until =
      begin + static_cast<std::int64_t>(seconds * static_cast<double>(timing::kSecond));
  // A session needs time to reach COMMANDING_ACTIVE, so listening is extended by kTimeToCommanding
  // until it does. It is also extended during a silence, until that ends or has lasted
  // kLastingSilence.
  constexpr std::int64_t kTimeToCommanding = 6 * timing::kSecond;
  const auto isWithinTime = [&](std::int64_t now) {
    const bool isSilent = now - hostTime_ > longestSilence();
    const bool isComing = state() != SessionState::CommandingActive && report_.received > 0;
    return now < until || isSilent || (isComing && now < until + kTimeToCommanding);
  };
  std::int64_t last = hostTime_ = begin;
  while (isWithinTime(timing::now())) {
    if (waitForMessage(timing::now() + 100 * timing::kMillisecond)) {
      listening.longestGap = std::max(listening.longestGap, hostTime_ - last);
      last = hostTime_;
      if (lastMessage_.ipoData && lastMessage_.ipoData->commandMode) {
        listening.mode = lastMessage_.ipoData->commandMode;
      }
      listening.hasWaited = listening.hasWaited || state() == SessionState::CommandingWait;
      isNew_ = false;
      answer(0.0, 0.0);
    } else if (timing::now() - last >= kLastingSilence) {
      listening.longestGap = timing::now() - last;
      break;
    }
  }
  listening.seconds = 1e-9 * static_cast<double>(timing::now() - begin);
  return listening;
}

std::vector<CheckResult> IiwaDevice::check(double seconds) {
  std::vector<CheckResult> found;
  try {
    if (lifecycle() == Lifecycle::Closed || lifecycle() == Lifecycle::Faulted) open();
  } catch (const DeviceError& error) {
    return {noConnection(error)};
  }
  found.push_back(
      {Finding::Pass,
       deviceMessage("check.connection"),
       deviceMessage("check.connection.fri", nameOf(settings_.version))});
  stopKeepAlive();
  const ListenResult listened = listen(seconds);
  const bool isSilent = timing::now() - hostTime_ >= kLastingSilence;
  const LinkReport report = link();
  found.push_back(sessionFinding(lastMessage_));
  found.push_back(
      commandingFinding(lastMessage_, settings_.overlay, listened.mode, listened.hasWaited));
  found.push_back(safetyFinding(lastMessage_));
  found.push_back(silenceFinding(listened.longestGap, isSilent, longestSilence()));
  found.push_back(cycleFinding(report, listened.seconds, 1e9 / static_cast<double>(period_)));
  found.push_back(anomalyFinding(report));
  found.push_back(
      {Finding::Pass,
       deviceMessage("check.answer"),
       deviceMessage(
           "check.median_and_p99",
           report.roundTrip.quantile(0.5),
           report.roundTrip.quantile(0.99))});
  const DeviceFault wrong = guard_.reasonNotToCommand(joints_, jointVelocity_, JointVector::Zero());
  found.push_back(passIf(
      !wrong,
      Finding::Fail,
      deviceMessage("check.joints"),
      wrong ? wrong.of(place()) : deviceMessage("check.joints.good"),
      deviceMessage("check.joints.fix")));
  const auto& at = tool_.position;
  found.push_back(
      {Finding::Pass,
       deviceMessage("check.tool"),
       deviceMessage("check.tool.place", at.x(), at.y(), at.z())});
  if (report.drift) found.push_back(driftFinding(*report.drift));
  found.push_back(
      {Finding::Pass,
       deviceMessage("check.force"),
       deviceMessage("check.force.newtons", capabilities_.maxForce)});
  found.push_back(torqueFinding(capabilities_));
  setCheckedUnlessFailed(found);
  startKeepAlive();  // from here on that thread updates what was received
  return found;
}

}  // namespace haptics::devices
