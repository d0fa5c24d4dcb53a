#include "study/model/trial_record.h"

#include <array>
#include <utility>

#include "study/model/messages.h"
#include "study/model/named_value.h"

namespace study {

base::NamedArguments valuesOf(const ViewReport& view) {
  return {
      {"frames", view.frames},
      {"dropped", view.dropped},
      {"rate_per_s", view.rate},
      {"frame_p50_ms", view.frameMedian},
      {"frame_p99_ms", view.frameP99},
      {"period_ms", view.period},
      {"latency_p50_ms", view.latencyMedian},
      {"latency_p99_ms", view.latencyP99},
      {"lost_changes", view.lostChanges},
      {"renderer", view.renderer}};
}

namespace {

constexpr std::array<std::string_view, 6> kEndings{
    "finished", "stopped", "aborted_hardware", "trace_lost", "timed_out", "program_ended"};
constexpr std::array<std::string_view, 3> kVerdicts{"PASS", "WARN", "FAIL"};

// The limits of libfranka, which warns below a success rate of 0.95 and calls 0.90 "not
// sufficient".
constexpr double kWarnRate = 0.95;
constexpr double kFailRate = 0.90;
constexpr double kWarnLateShare = 0.01;
constexpr double kWarnSaturatedShare = 0.05;

struct Finding {
  Verdict verdict = Verdict::Pass;
  base::Message reason;
};

/// Warns of what a participant may have noticed. Every trial begins with a soft start, which is
/// reported only if it lasted for half of the trial: the trial then had hardly any force.
Finding findingOf(const SafetyEvent& event, double duration) {
  const auto found = [&](Verdict verdict, auto key) {
    return Finding{verdict, message(key, event.times, event.duration)};
  };
  using Key = base::CheckedKey<kMessages, 2>;
  switch (event.kind) {
    case SafetyKind::TooFast:
      return found(Verdict::Warn, Key("trial.too_fast"));
    case SafetyKind::DeadManReleased:
      return found(Verdict::Warn, Key("trial.released"));
    case SafetyKind::MissedPeriods:
      return found(Verdict::Warn, Key("trial.lost_beats"));
    case SafetyKind::NotFinite:
      return found(Verdict::Fail, Key("trial.not_finite"));
    case SafetyKind::Active:
      return found(Verdict::Warn, Key("trial.active"));
    case SafetyKind::SoftStart:
      if (event.duration <= 0.5 * duration) return {};
      return found(Verdict::Fail, Key("trial.soft_start"));
    case SafetyKind::NoSample:
    case SafetyKind::Saturated:
    case SafetyKind::Slewed:
    case SafetyKind::Damped:
    case SafetyKind::TorqueSaturated:
    case SafetyKind::TorqueSlewed:
    case SafetyKind::TorqueActive:
      return {};  // reported from other members of the record, or a normal effect of the limits
  }
  return {};
}

}  // namespace

std::string_view nameOf(TrialEnding ending) noexcept {
  return kEndings[static_cast<std::size_t>(ending)];
}

std::optional<TrialEnding> trialEndingNamed(std::string_view name) noexcept {
  return valueNamed<TrialEnding>(kEndings, name);
}

std::string_view nameOf(Verdict verdict) noexcept {
  return kVerdicts[static_cast<std::size_t>(verdict)];
}

std::optional<Verdict> verdictNamed(std::string_view name) noexcept {
  return valueNamed<Verdict>(kVerdicts, name);
}

bool isOftenLate(std::int64_t lateTicks, std::int64_t ticks) noexcept {
  return static_cast<double>(lateTicks) > kWarnLateShare * static_cast<double>(ticks);
}

base::NamedArguments valuesOf(const haptics::devices::LinkReport& link) {
  base::NamedArguments values;
  const auto add = [&](const char* name, auto value) {
    values.emplace_back(name, base::asArgument(value));
  };
  add("received", link.received);
  add("lost", link.lost);
  add("doubled", link.doubled);
  add("late", link.late);
  add("damaged", link.damaged);
  add("foreign", link.foreign);
  add("restarts", link.restarts);
  add("skipped", link.skipped);
  add("stale", link.stale);
  add("poor", link.poorConnectionSamples);
  add("unsent", link.unsent);
  add("clipped", link.clipped);
  add("expired", link.expired);
  add("trip_p50_us", link.roundTrip.quantile(0.5));
  add("trip_p99_us", link.roundTrip.quantile(0.99));
  add("trip_max_us", link.roundTrip.largest());
  add("clock_offset_ns", link.clockOffset);
  if (link.drift) add("drift_ppm", *link.drift);
  if (link.leaps > 0) add("leaps", link.leaps);
  return values;
}

TrialRecord::Judgement TrialRecord::judgement() const {
  Judgement judgement;
  const auto found = [&](Verdict verdict, base::Message reason) {
    if (verdict > judgement.verdict) judgement.verdict = verdict;
    judgement.reasons.push_back(std::move(reason));
  };
  if (ending != TrialEnding::Finished) {
    found(
        Verdict::Fail,
        deviceFault.empty() ? message("trial.broke_off", nameOf(ending))
                            : message("trial.broke_off.fault", nameOf(ending), deviceFault));
  }
  if (lacksDevice) found(Verdict::Fail, message("trial.no_device"));
  if (traceSamples + lostSamples != ticks) {
    found(Verdict::Fail, message("trial.samples_kept", traceSamples, ticks));
  }
  if (lostSamples > 0) {
    found(
        Verdict::Fail,
        lostSamples == 1 ? message("trial.samples_lost.one", lostSamples)
                         : message("trial.samples_lost", lostSamples));
  }
  if (invalidTicks > 0) {
    // A single missing sample is extrapolated; on a link, single samples are lost now and then.
    const bool isRare = link.hasLink && static_cast<double>(invalidTicks) <
                                            kWarnLateShare * static_cast<double>(ticks);
    found(
        isRare ? Verdict::Warn : Verdict::Fail,
        invalidTicks == 1 ? message("trial.device_silent.one", invalidTicks)
                          : message("trial.device_silent", invalidTicks));
  }
  if (link.lost + link.doubled + link.late + link.damaged + link.foreign > 0) {
    found(
        Verdict::Warn,
        message(
            "trial.wire_faults", link.lost, link.doubled, link.late, link.damaged, link.foreign));
  }
  if (link.leaps > 0) {
    found(
        Verdict::Warn,
        link.leaps == 1 ? message("trial.leaps.one", link.leaps)
                        : message("trial.leaps", link.leaps));
  }
  if (link.clipped > 0) {
    found(
        Verdict::Warn,
        link.clipped == 1 ? message("trial.clipped.one", link.clipped)
                          : message("trial.clipped", link.clipped));
  }
  const double share = achievedRate ? *achievedRate / nominalRate : 1.0;
  if (share < kWarnRate) {
    found(
        share < kFailRate ? Verdict::Fail : Verdict::Warn,
        message("trial.rate", *achievedRate, nominalRate));
  }
  if (lateTicks && isOftenLate(*lateTicks, ticks)) {
    found(
        Verdict::Warn,
        hostPauses.value_or(0) > 0 ? message("trial.late.machine", *lateTicks, ticks, *hostPauses)
                                   : message("trial.late", *lateTicks, ticks));
  }
  if (contact > 0.0 && saturated > kWarnSaturatedShare * contact) {
    found(Verdict::Warn, message("trial.cut_off", saturated, contact));
  }
  if (contact > 0.0 && torqueSaturated > kWarnSaturatedShare * contact) {
    found(Verdict::Warn, message("trial.torque_cut_off", torqueSaturated, contact));
  }
  if (hasTorque && !isTorqueRendered) found(Verdict::Warn, message("trial.no_torque"));
  if (undefined > 0.0) found(Verdict::Warn, message("trial.no_force", undefined));
  if (const auto& cycle = passivity.limitCycle) {
    found(Verdict::Fail, message("trial.limit_cycle", cycle->amplitude, cycle->frequency));
  }
  const double needed = passivity.requiredDamping();
  if (needed > deviceDamping) {
    found(Verdict::Warn, message("trial.damping", needed, travelUnit, deviceDamping));
  }
  for (const auto& event : safety) {
    auto [verdict, reason] = findingOf(event, duration);
    if (verdict != Verdict::Pass) found(verdict, std::move(reason));
  }
  return judgement;
}

}  // namespace study
