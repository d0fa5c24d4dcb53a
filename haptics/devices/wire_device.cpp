#include "haptics/devices/wire_device.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "haptics/devices/device.h"
#include "haptics/timing/monotonic_clock.h"

namespace haptics::devices {

WireDevice::WireDevice(Capabilities capabilities, KeepAliveLimits limits)
    : capabilities_(std::move(capabilities)), keepAliveLimits_(limits) {}

void WireDevice::close() noexcept {
  stopKeepAlive();
  disconnect(false);
  setLifecycle(Lifecycle::Closed);
}

void WireDevice::finishOpening() {
  faultKind_.store(nullptr);
  setLifecycle(Lifecycle::Open);
  startKeepAlive();
}

void WireDevice::startKeepAlive() {
  hostTime_ = timing::now();
  keepAliveThread_ = std::jthread([this](const std::stop_token& stop) {
    timing::raisePriority(timing::kLoopPriority);
    while (!stop.stop_requested() && lifecycle() != Lifecycle::Faulted) {
      if (waitForMessage(timing::now() + keepAliveLimits_.longestWait)) {
        isNew_ = false;
        keepAlive();
      }
      if (!isConnected()) fail("fault.unplugged");
      if (timing::now() - hostTime_ > keepAliveLimits_.silence) fail("fault.silent");
    }
  });
}

void WireDevice::stopKeepAlive() noexcept {
  if (!keepAliveThread_.joinable()) return;
  keepAliveThread_.request_stop();
  keepAliveThread_.join();
}

void WireDevice::resumeKeepAlive() noexcept {
  try {
    startKeepAlive();
  } catch (...) {
    fail("fault.no_thread");
  }
}

void WireDevice::arm() {
  stopKeepAlive();  // a fault that the keep-alive thread detected is handled below
  if (lifecycle() == Lifecycle::Closed || lifecycle() == Lifecycle::Faulted) {
    std::vector<base::Message> why;
    if (auto present = fault(); !present.empty()) why.push_back(std::move(present));
    why.push_back(deviceMessage("device.not_ready", place()));
    throw DeviceError(std::move(why));
  }
  try {
    awaitReadiness();
  } catch (...) {
    startKeepAlive();
    throw;
  }
  resetCounts();
  beginForces();
  setLifecycle(Lifecycle::Armed);
  startKeepAlive();  // runs until the first tick
}

void WireDevice::disarm() noexcept {
  const auto was = lifecycle();
  if (was != Lifecycle::Armed && was != Lifecycle::Running) return;
  stopKeepAlive();
  if (lifecycle() == Lifecycle::Faulted) return;
  stopForces();
  setLifecycle(Lifecycle::Open);
  resumeKeepAlive();
}

CheckResult WireDevice::noConnection(const DeviceError& error) {
  return {
      Finding::Fail,
      deviceMessage("check.connection"),
      deviceMessage("check.connection.failed"),
      error.messages().front()};
}

CheckResult WireDevice::driftFinding(double drift) {
  return passIf(
      std::abs(drift) < 500.0,
      Finding::Warn,
      deviceMessage("check.clock"),
      deviceMessage("check.clock.drift", drift),
      deviceMessage("check.clock.fix"));
}

void WireDevice::setCheckedUnlessFailed(const std::vector<CheckResult>& results) noexcept {
  const auto isFailure = [](const CheckResult& result) { return result.finding == Finding::Fail; };
  if (std::ranges::any_of(results, isFailure)) return;
  auto open = Lifecycle::Open;
  lifecycle_.compare_exchange_strong(open, Lifecycle::Checked);
}

void WireDevice::fail(DeviceFault why) noexcept {
  if (lifecycle() != Lifecycle::Faulted) {
    faultJoint_.store(why.joint());
    faultKind_.store(why.kind());
  }
  disconnect(true);
  setLifecycle(Lifecycle::Faulted);
}

base::Message WireDevice::fault() const {
  const auto* kind = faultKind_.load();
  return DeviceFault(kind, faultJoint_.load()).of(place());
}

bool WireDevice::wait(std::int64_t deadline) noexcept {
  if (!isConnected()) {
    timing::sleepUntil(deadline);
    return false;
  }
  stopKeepAlive();  // from the first tick on the loop's thread uses the connection
  return waitForMessage(deadline);
}

void WireDevice::resetCounts() noexcept {
  report_ = {.hasLink = true};
  drift_ = {};
}

LinkReport WireDevice::link() {
  // Before the first tick the keep-alive thread runs and updates the counts, too. So it is stopped
  // while they are read.
  const bool wasRunning = isKeepAliveRunning();
  stopKeepAlive();
  LinkReport report = report_;
  report.drift = drift_.partsPerMillion();
  report.clockOffset = drift_.offset();
  if (wasRunning) resumeKeepAlive();
  return report;
}

}  // namespace haptics::devices
