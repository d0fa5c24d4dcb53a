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
      "session",
      std::string(kStateNames.at(state)) + ", connection " + kQualityNames.at(quality),
      isGood && isReady ? ""
      : isGood
          ? "Start the robot's application."
          : "Connect the controller directly to this computer, and give this program real-time "
            "priority: the page on devices, \"Real time\", says how."};
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
  const std::string choose = "hoose " + ours + " in the robot's application.";
  return {
      Finding::Fail,
      "force overlay",
      "the robot takes: " + theirs + "; the device file's overlay is " + ours,
      canBeOurs ? "Write \"overlay\": \"" + theirs + "\" in the device file, or c" + choose
                : "C" + choose};
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
  if (isActive && mode) return {Finding::Pass, "force overlay", "active", ""};
  if (isActive) {
    return {
        Finding::Fail,
        "force overlay",
        "active, in a mode that the robot does not name",
        std::string("Choose ") + wordFor(wanted) + " in the robot's application."};
  }
  return {
      Finding::Warn,
      "force overlay",
      hasWaited ? "waits in COMMANDING_WAIT" : "not commanding yet",
      std::string("Let the robot's application start its motion with the FRI overlay.") +
          (hasWaited ? " If it has: the device file's \"overlay\" (wrench or torque) may be "
                       "another than the robot's."
                     : "")};
}

/// Reports the longest time [ns] without a message. A trial ends after @p limit [ns]; a short
/// excess may come from a busy computer and is only a warning.
CheckResult silenceFinding(std::int64_t longest, bool isLasting, std::int64_t limit) {
  constexpr std::int64_t kLongestExcusedSilence = timing::kSecond / 2;
  const double seconds = 1e-9 * static_cast<double>(longest);
  const std::string measured =
      longest <= limit ? formatNumbers("%.0f ms", 1e3 * seconds)
                       : formatNumbers(
                             isLasting ? "nothing has come from the arm for %.1f s (a trial ends "
                                         "at %.0f ms)"
                                       : "%.3f s (a trial ends at %.0f ms)",
                             seconds,
                             1e-6 * static_cast<double>(limit));
  return {
      longest <= limit                                ? Finding::Pass
      : isLasting || longest > kLongestExcusedSilence ? Finding::Fail
                                                      : Finding::Warn,
      "longest silence",
      measured,
      longest <= limit ? ""
      : isLasting      ? "Is the application still running? Look at the SmartPad, and at the cable."
                       : "End other programs on this computer, and use a direct cable; look at the "
                         "SmartPad for what stopped it."};
}

CheckResult safetyFinding(const MonitoringMessage& message) {
  const auto info = message.robotInfo.value_or(RobotInfo{});
  const bool isNormal =
      info.safetyState.value_or(SafetyState::NormalOperation) == SafetyState::NormalOperation;
  return {
      isNormal ? Finding::Pass : Finding::Fail,
      "safety state",
      isNormal ? "normal operation" : "safety stop",
      isNormal ? "" : "Resolve the stop at the robot, then check again."};
}

CheckResult cycleFinding(const LinkReport& link, double seconds, double rate) {
  const double seen = static_cast<double>(link.received) / seconds;
  const bool isNear = std::abs(seen / rate - 1.0) < 0.05;
  return {
      isNear ? Finding::Pass : Finding::Warn,
      "cycle",
      formatNumbers("%.0f messages/s of %.0f", seen, rate),
      isNear ? ""
             : "End other programs on this computer; choose a longer send period on the robot."};
}

CheckResult anomalyFinding(const LinkReport& link) {
  const auto bad = link.lost + link.doubled + link.late + link.damaged + link.foreign;
  return {
      bad == 0 ? Finding::Pass : Finding::Warn,
      "messages lost, doubled, late, damaged, foreign",
      std::to_string(link.lost) + ", " + std::to_string(link.doubled) + ", " +
          std::to_string(link.late) + ", " + std::to_string(link.damaged) + ", " +
          std::to_string(link.foreign),
      bad == 0 ? ""
               : "Use a direct cable; no other computer on this network may send to this port."};
}

CheckResult torqueFinding(const Capabilities& capabilities) {
  return {
      Finding::Pass,
      "torque at most",
      capabilities.rendersTorque() ? formatNumbers("%.3g N·m", capabilities.maxTorque)
                                   : "not rendered: torque",
      ""};
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
    found.push_back({Finding::Fail, "connection", "none", error.what()});
    return found;
  }
  found.push_back(
      {Finding::Pass, "connection", "FRI " + std::string(nameOf(settings_.version)), ""});
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
       "answer seen by the robot after",
       formatNumbers(
           "median %.0f µs, p99 %.0f µs",
           report.roundTrip.quantile(0.5),
           report.roundTrip.quantile(0.99)),
       ""});
  const char* wrong = guard_.reasonNotToCommand(joints_, jointVelocity_, JointVector::Zero());
  found.push_back(
      {wrong == nullptr ? Finding::Pass : Finding::Fail,
       "joints",
       wrong == nullptr ? "within their margins" : wrong,
       wrong == nullptr ? "" : "Move the arm to its starting pose."});
  found.push_back(
      {Finding::Pass,
       "tool",
       formatNumbers(
           "at %.4f, %.4f, %.4f m", tool_.position.x(), tool_.position.y(), tool_.position.z()),
       ""});
  if (report.drift) {
    found.push_back(
        {std::abs(*report.drift) < 500.0 ? Finding::Pass : Finding::Warn,
         "clock against ours",
         formatNumbers("%+.1f ppm", *report.drift),
         ""});
  }
  found.push_back(
      {Finding::Pass, "force at most", formatNumbers("%.0f N", capabilities_.maxForce), ""});
  found.push_back(torqueFinding(capabilities_));
  setCheckedUnlessFailed(found);
  startKeepAlive();  // from here on that thread updates what was received
  return found;
}

}  // namespace haptics::devices
