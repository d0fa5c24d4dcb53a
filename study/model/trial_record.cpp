#include "study/model/trial_record.h"

#include <array>

#include <fmt/format.h>

#include "study/words/counted.h"

namespace study {
namespace {

constexpr std::array<std::string_view, 6> kEndings{
    "finished", "stopped", "aborted_hardware", "trace_lost", "timed_out", "program_ended"};
constexpr std::array<std::string_view, 10> kSafetyKinds{
    "too_fast",
    "released",
    "no_sample",
    "lost_beats",
    "soft_start",
    "saturated",
    "slewed",
    "not_finite",
    "active",
    "damped"};
constexpr std::array<std::string_view, 3> kVerdicts{"PASS", "WARN", "FAIL"};

// libfranka warns below a success rate of 0.95 and calls 0.90 "not sufficient"; we ask for the
// same.
constexpr double kWarnRate = 0.95;
constexpr double kFailRate = 0.90;
constexpr double kWarnLateShare = 0.01;
constexpr double kWarnSaturatedShare = 0.05;

struct Finding {
  Verdict verdict = Verdict::Pass;
  const char* what = "";
};

/// What a participant may have noticed. A force comes on softly in every trial; where that takes
/// half of it, it hardly came.
Finding verdictOf(const SafetyEvent& event, double duration) {
  switch (event.kind) {
    case SafetyKind::TooFast:
      return {Verdict::Warn, "the tool was too fast, and the force faded"};
    case SafetyKind::Released:
      return {Verdict::Warn, "the dead-man switch was released"};
    case SafetyKind::LostBeats:
      return {Verdict::Warn, "the loop lost beats, and the force faded"};
    case SafetyKind::NotFinite:
      return {Verdict::Fail, "the scene asked for a force that is no number"};
    case SafetyKind::Active:
      return {Verdict::Warn, "the scene gave more energy than it was given: it may have vibrated"};
    case SafetyKind::SoftStart:
      if (event.duration <= 0.5 * duration) return {};
      return {Verdict::Fail, "the force never came on: the scene asked for too much all along"};
    case SafetyKind::NoSample:
    case SafetyKind::Saturated:
    case SafetyKind::Slewed:
    case SafetyKind::Damped:
      return {};  // said elsewhere, or as asked for
  }
  return {};
}

}  // namespace

std::string_view nameOf(TrialEnding ending) noexcept {
  return kEndings[static_cast<std::size_t>(ending)];
}

std::string_view nameOf(SafetyKind kind) noexcept {
  return kSafetyKinds[static_cast<std::size_t>(kind)];
}

std::string_view nameOf(Verdict verdict) noexcept {
  return kVerdicts[static_cast<std::size_t>(verdict)];
}

bool isOftenLate(std::int64_t lateTicks, std::int64_t ticks) noexcept {
  return static_cast<double>(lateTicks) > kWarnLateShare * static_cast<double>(ticks);
}

std::string inWords(const haptics::devices::LinkReport& link) {
  std::string words = fmt::format(
      "received {}, lost {}, doubled {}, late {}, damaged {}, foreign {}, restarts {}, skipped {}, "
      "stale {}, poor {}, unsent {}, clipped {}, expired {}; round trip p50 {:.0f} us, p99 {:.0f} "
      "us, "
      "largest {:.0f} us; device's 0 at {} ns of our clock",
      link.received,
      link.lost,
      link.doubled,
      link.late,
      link.damaged,
      link.foreign,
      link.restarts,
      link.skipped,
      link.stale,
      link.poor,
      link.unsent,
      link.clipped,
      link.expired,
      link.roundTrip.quantile(0.5),
      link.roundTrip.quantile(0.99),
      link.roundTrip.largest(),
      link.clockOffset);
  if (link.drift) words += fmt::format(", drift {:+.2f} ppm", *link.drift);
  return words;
}

TrialRecord::Judgement TrialRecord::judgement() const {
  Judgement judgement;
  const auto found = [&](Verdict verdict, std::string reason) {
    if (verdict > judgement.verdict) judgement.verdict = verdict;
    judgement.reason += (judgement.reason.empty() ? "" : "; ") + reason;
  };
  if (ending != TrialEnding::Finished) {
    const std::string why = deviceFault.empty() ? "" : ": " + deviceFault;
    found(Verdict::Fail, fmt::format("the trial broke off ({}{})", nameOf(ending), why));
  }
  if (traceSamples + lostSamples != ticks) {
    found(Verdict::Fail, fmt::format("{} of {} samples were kept", traceSamples, ticks));
  }
  if (lostSamples > 0)
    found(
        Verdict::Fail,
        words::counted(
            static_cast<std::uint64_t>(lostSamples), "sample was lost", "samples were lost"));
  if (invalidTicks > 0) {
    // One missing sample is bridged; a device on a wire misses one now and then.
    const bool isRare = link.isThere && static_cast<double>(invalidTicks) <
                                            kWarnLateShare * static_cast<double>(ticks);
    found(
        isRare ? Verdict::Warn : Verdict::Fail,
        "the device was silent for " +
            words::counted(static_cast<std::uint64_t>(invalidTicks), "tick"));
  }
  if (const auto bad = link.lost + link.doubled + link.late + link.damaged + link.foreign;
      bad > 0) {
    found(
        Verdict::Warn,
        fmt::format(
            "on the device's wire {} were lost, {} doubled, {} late, {} damaged, {} foreign",
            link.lost,
            link.doubled,
            link.late,
            link.damaged,
            link.foreign));
  }
  if (link.clipped > 0) {
    found(
        Verdict::Warn,
        "the device gave less than it was asked for in " +
            words::counted(static_cast<std::uint64_t>(link.clipped), "tick"));
  }
  const double share = achievedRate ? *achievedRate / nominalRate : 1.0;
  if (share < kWarnRate) {
    found(
        share < kFailRate ? Verdict::Fail : Verdict::Warn,
        fmt::format("{:.0f} of {:.0f} Hz were reached", *achievedRate, nominalRate));
  }
  if (lateTicks && isOftenLate(*lateTicks, ticks)) {
    found(
        Verdict::Warn,
        fmt::format("{} of {} ticks were late", *lateTicks, ticks) +
            (holes.value_or(0) > 0
                 ? fmt::format(", {} of them because the machine itself stood still", *holes)
                 : ""));
  }
  if (contact > 0.0 && saturated > kWarnSaturatedShare * contact) {
    found(
        Verdict::Warn,
        fmt::format("the force was cut off for {:.2f} s of {:.2f} s", saturated, contact));
  }
  if (undefined > 0.0) {
    found(Verdict::Warn, fmt::format("the scene had no force for {:.3f} s", undefined));
  }
  const double needed = passivity.neededDamping();
  if (needed > deviceDamping) {
    found(
        Verdict::Warn,
        fmt::format(
            "passivity (b > KT/2) needs {:.3g} N·s/{} of damping, the device has {:.3g}, the rest "
            "is the hand's",
            needed,
            travelUnit,
            deviceDamping));
  }
  for (const auto& event : safety) {
    if (const auto [verdict, what] = verdictOf(event, duration); verdict != Verdict::Pass) {
      found(verdict, fmt::format("{} ({}×, {:.3f} s)", what, event.times, event.duration));
    }
  }
  return judgement;
}

}  // namespace study
