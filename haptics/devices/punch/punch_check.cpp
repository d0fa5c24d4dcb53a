// The check of a punch: PunchDevice::check().
#include <cmath>
#include <utility>

#include "haptics/devices/device.h"
#include "haptics/devices/punch/punch_device.h"
#include "haptics/timing/monotonic_clock.h"

namespace haptics::devices {
namespace {

CheckResult rateFinding(const LinkReport& link, double seconds, double nominal) {
  const double rate = static_cast<double>(link.received) / seconds;
  const bool isNear = std::abs(rate / nominal - 1.0) < 0.05;
  return passIf(
      isNear,
      Finding::Warn,
      deviceMessage("check.telemetry"),
      deviceMessage("check.telemetry.rate", rate, nominal),
      deviceMessage("check.telemetry.fix"));
}

CheckResult frameLossFinding(const LinkReport& link) {
  const auto bad = link.lost + link.doubled + link.late + link.damaged;
  const double share =
      static_cast<double>(bad) / static_cast<double>(std::max<std::uint64_t>(link.received, 1));
  return passIf(
      bad == 0,
      share < 0.001 ? Finding::Warn : Finding::Fail,
      deviceMessage("check.frames"),
      deviceMessage("check.frames.counts", link.lost, link.doubled, link.late, link.damaged),
      deviceMessage("check.frames.fix"));
}

CheckResult roundTripFinding(const LinkReport& link) {
  const double p99 = link.roundTrip.quantile(0.99);
  return passIf(
      p99 < 3000.0,
      Finding::Warn,
      deviceMessage("check.round_trip"),
      deviceMessage("check.median_and_p99", link.roundTrip.quantile(0.5), p99),
      deviceMessage("check.round_trip.fix"));
}

CheckResult leapFinding(std::uint64_t leaps) {
  return passIf(
      leaps == 0,
      Finding::Warn,
      deviceMessage("check.leaps"),
      base::Message::verbatim(std::to_string(leaps)),
      deviceMessage("check.leaps.fix"));
}

/// One result for each bit of State::faults; one that passes if there is none.
std::vector<CheckResult> faultFindings(std::uint8_t faults) {
  using namespace wire::punch;
  const std::pair<std::uint8_t, base::Message> kinds[]{
      {kExpired, deviceMessage("check.board_faults.expired")},
      {kSaturated, deviceMessage("check.board_faults.saturated")},
      {kTooFast, deviceMessage("check.board_faults.too_fast")},
      {kDriverFault, deviceMessage("check.board_faults.driver")},
      {kEncoderFault, deviceMessage("check.board_faults.encoder")},
      {kBadFrames, deviceMessage("check.board_faults.bad_frames")},
      {kNotArmed, deviceMessage("check.board_faults.not_armed")},
      {kClockWrapped, deviceMessage("check.board_faults.clock")}};
  const auto what = deviceMessage("check.board_faults");
  std::vector<CheckResult> found;
  for (const auto& [bit, meaning] : kinds) {
    if ((faults & bit) == 0) continue;
    found.push_back(passIf(
        (bit & kLatchedFaults) == 0,
        Finding::Fail,
        what,
        meaning,
        deviceMessage("check.board_faults.fix")));
  }
  if (found.empty()) found.push_back({Finding::Pass, what, deviceMessage("check.none")});
  return found;
}

}  // namespace

std::vector<CheckResult> PunchDevice::check(double seconds) {
  const std::string unit(settings_.kind->travel.unitName);
  std::vector<CheckResult> found;
  try {
    if (lifecycle() == Lifecycle::Closed || lifecycle() == Lifecycle::Faulted) open();
    found.push_back(
        {Finding::Pass,
         deviceMessage("check.firmware"),
         deviceMessage(
             "check.firmware.found",
             hello_.protocolVersion,
             hello_.serial,
             1e-3 * hello_.largestVoltage,
             hello_.rate)});
    arm();
  } catch (const DeviceError& error) {
    return {noConnection(error)};
  }
  const std::int64_t until =
      timing::now() + static_cast<std::int64_t>(seconds * static_cast<double>(timing::kSecond));
  bool isFaulty = false;
  double least = 1e300;
  double most = -1e300;
  while (!isFaulty && timing::now() < until) {
    wait(timing::now() + 2 * timing::kMillisecond);
    const auto sample = read(0.001);
    isFaulty =
        sample.status == DeviceStatus::NotAnswering || sample.status == DeviceStatus::Faulted;
    if (sample.status == DeviceStatus::Ok) {
      least = std::min(least, sample.travel);
      most = std::max(most, sample.travel);
    }
    command(0.0, 0.0);
  }
  const LinkReport report = link();
  const std::uint8_t faults = state_.faults;
  disarm();
  if (isFaulty) {
    found.push_back(
        {Finding::Fail,
         deviceMessage("check.faults"),
         fault(),
         deviceMessage("check.board_faults.fix")});
    return found;
  }
  found.push_back(rateFinding(report, seconds, capabilities_.rate));
  found.push_back(frameLossFinding(report));
  found.push_back(roundTripFinding(report));
  found.push_back(leapFinding(report.leaps));
  const auto& plausibleTravel = settings_.kind->serial.plausibleTravel;
  const bool isWithin = least >= plausibleTravel.least && most <= plausibleTravel.most;
  found.push_back(passIf(
      isWithin,
      Finding::Warn,
      deviceMessage("check.travel"),
      deviceMessage("check.travel.range", least, most, unit),
      deviceMessage("check.travel.fix")));
  for (auto& result : faultFindings(faults)) found.push_back(std::move(result));
  if (report.drift) found.push_back(driftFinding(*report.drift));
  found.push_back(
      {Finding::Pass,
       deviceMessage("check.force"),
       deviceMessage("check.force.volts", capabilities_.maxForce, settings_.newtonsPerVolt)});
  setCheckedUnlessFailed(found);
  return found;
}

}  // namespace haptics::devices
