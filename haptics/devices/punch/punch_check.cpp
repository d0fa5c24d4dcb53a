// The check of a punch: PunchDevice::check().
#include <array>
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
  return {
      isNear ? Finding::Pass : Finding::Warn,
      "telemetry",
      formatNumbers("%.0f samples/s of %.0f", rate, nominal),
      isNear ? "" : "Use the board's native USB port, and end other programs on this computer."};
}

CheckResult frameLossFinding(const LinkReport& link) {
  const auto bad = link.lost + link.doubled + link.late + link.damaged;
  const double share =
      static_cast<double>(bad) / static_cast<double>(std::max<std::uint64_t>(link.received, 1));
  const Finding finding = bad == 0 ? Finding::Pass : share < 0.001 ? Finding::Warn : Finding::Fail;
  return {
      finding,
      "frames lost, doubled, late, damaged",
      std::to_string(link.lost) + ", " + std::to_string(link.doubled) + ", " +
          std::to_string(link.late) + ", " + std::to_string(link.damaged),
      bad == 0 ? "" : "Change the cable, and plug it into the computer itself, not into a hub."};
}

CheckResult roundTripFinding(const LinkReport& link) {
  const double p99 = link.roundTrip.quantile(0.99);
  const bool isShort = p99 < 3000.0;
  return {
      isShort ? Finding::Pass : Finding::Warn,
      "round trip",
      formatNumbers("median %.0f µs, p99 %.0f µs", link.roundTrip.quantile(0.5), p99),
      isShort
          ? ""
          : "Stiff scenes may vibrate. Give this program real-time priority: the page on devices, "
            "\"Real time\", says how."};
}

CheckResult leapFinding(std::uint64_t leaps) {
  return {
      leaps == 0 ? Finding::Pass : Finding::Warn,
      "leaps of the position",
      std::to_string(leaps),
      leaps == 0 ? "" : "Check the encoder's cable."};
}

/// Describes the bits of State::faults.
std::string describeFaults(std::uint8_t faults) {
  using namespace wire::punch;
  constexpr std::array<std::pair<std::uint8_t, const char*>, 8> kWords{
      {{kExpired, "no force came in time, so it let go"},
       {kSaturated, "it was asked for more than its largest voltage"},
       {kTooFast, "it moves faster than any hand"},
       {kDriverFault, "the motor's driver reports a fault"},
       {kEncoderFault, "its encoder jumps"},
       {kBadFrames, "damaged frames have reached it"},
       {kNotArmed, "it is not armed"},
       {kClockWrapped, "its clock has begun again at 0"}}};
  std::string words;
  for (const auto& [bit, meaning] : kWords) {
    if ((faults & bit) != 0) words += (words.empty() ? "" : "; ") + std::string(meaning);
  }
  return words.empty() ? "none" : words;
}

}  // namespace

std::vector<CheckResult> PunchDevice::check(double seconds) {
  const std::string kind(settings_.kind->name);
  const std::string unit(settings_.kind->travel.unitName);
  std::vector<CheckResult> found;
  try {
    if (lifecycle() == Lifecycle::Closed || lifecycle() == Lifecycle::Faulted) open();
    found.push_back(
        {Finding::Pass,
         "firmware",
         "protocol " + std::to_string(hello_.protocolVersion) + ", board " +
             std::to_string(hello_.serial) + ", up to " +
             formatNumbers("%.1f V, %.0f Hz", 1e-3 * hello_.largestVoltage, hello_.rate),
         ""});
    arm();
  } catch (const DeviceError& error) {
    found.push_back({Finding::Fail, "connection", "none", error.what()});
    return found;
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
         "faults",
         fault(),
         "Switch the " + kind + " off and on, then check it again."});
    return found;
  }
  found.push_back(rateFinding(report, seconds, capabilities_.rate));
  found.push_back(frameLossFinding(report));
  found.push_back(roundTripFinding(report));
  found.push_back(leapFinding(report.leaps));
  const auto& plausibleTravel = settings_.kind->serial.plausibleTravel;
  const bool isWithin = least >= plausibleTravel.least && most <= plausibleTravel.most;
  found.push_back(
      {isWithin ? Finding::Pass : Finding::Warn,
       "travel",
       formatNumbers("%.3f to %.3f ", least, most) + unit,
       isWithin
           ? ""
           : "Open the " + kind + " altogether, and correct travel_at_zero in the device file."});
  found.push_back(
      {(faults & wire::punch::kLatchedFaults) == 0 ? Finding::Pass : Finding::Fail,
       "faults that the board reports",
       describeFaults(faults),
       (faults & wire::punch::kLatchedFaults) == 0
           ? ""
           : "Switch the " + kind + " off and on, then check again."});
  if (report.drift) {
    const bool isSteady = std::abs(*report.drift) < 500.0;
    found.push_back(
        {isSteady ? Finding::Pass : Finding::Warn,
         "clock against ours",
         formatNumbers("%+.1f ppm", *report.drift),
         isSteady ? ""
                  : "The board's crystal may be broken; times of the device are not to be used."});
  }
  found.push_back(
      {Finding::Pass,
       "force at most",
       formatNumbers("%.2f N (%.3f N/V)", capabilities_.maxForce, settings_.newtonsPerVolt),
       ""});
  setCheckedUnlessFailed(found);
  return found;
}

}  // namespace haptics::devices
