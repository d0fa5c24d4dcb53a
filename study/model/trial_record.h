#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "haptics/devices/device.h"
#include "haptics/engine/passivity.h"
#include "haptics/models/cut_detector.h"
#include "study/model/view_report.h"

namespace study {

/// How a trial ended.
enum class TrialEnding {
  Finished,    ///< enough was felt
  Stopped,     ///< somebody pressed stop
  DeviceGone,  ///< no force; the operator decides
  TraceLost,   ///< what was felt could not be kept
  TimedOut,    ///< nobody cut
  ProgramEnded,
};

std::string_view nameOf(TrialEnding ending) noexcept;
std::optional<TrialEnding> trialEndingNamed(std::string_view name) noexcept;

/// What kept a force from the hand, or was wrong with it.
enum class SafetyKind {
  TooFast,        ///< the tool exceeded the limit of velocity
  Released,       ///< the dead-man switch was not held
  NoSample,       ///< the device gave no measurement
  MissedPeriods,  ///< the clock missed more than one period
  SoftStart,      ///< the force waited for a small one, or came on
  Saturated,      ///< the scene asked for more than the limit
  Slewed,         ///< … or faster than it
  NotFinite,      ///< … or for what is no number
  Active,         ///< it gave more energy than it was given
  Damped,         ///< and was damped
};

std::string_view nameOf(SafetyKind kind) noexcept;

/// How often one of these happened in a trial, and for how long.
struct SafetyEvent {
  SafetyKind kind = SafetyKind::TooFast;
  std::int64_t times = 0;
  double duration = 0.0;  ///< in all [s]
};

enum class Verdict { Pass, Warn, Fail };

std::string_view nameOf(Verdict verdict) noexcept;
std::optional<Verdict> verdictNamed(std::string_view name) noexcept;

/// Whether a loop was late in more ticks than a trial bears without a warning.
bool isOftenLate(std::int64_t lateTicks, std::int64_t ticks) noexcept;

/// What came over a device's wire, for the record: {"received", 5000}, {"lost", 2}, …
base::NamedArguments valuesOf(const haptics::devices::LinkReport& link);

/// What was felt in a trial, and how well it was rendered: proof of the one, quality of the other.
struct TrialRecord {
  using Cut = haptics::models::CutDetector<double>::Cut;

  std::string device;  ///< its name, for people
  std::string travelUnit;
  TrialEnding ending = TrialEnding::Finished;
  double duration = 0.0;  ///< of the engine's own time [s]
  std::int64_t ticks = 0;
  double nominalRate = 1000.0;            ///< [Hz]
  std::optional<double> achievedRate;     ///< [Hz]; nothing where no clock was running
  std::optional<double> latenessMedian;   ///< of waking up [µs]
  std::optional<double> latenessP99;      ///< [µs]
  std::optional<double> latenessLargest;  ///< [µs]
  std::optional<std::int64_t> lateTicks;  ///< by more than a period
  std::optional<std::int64_t> holes;      ///< of these, what the machine below us caused
  std::int64_t lostSamples = 0;           ///< the recorder could not keep up
  std::int64_t invalidTicks = 0;          ///< the device gave no measurement
  double saturated = 0.0;                 ///< the scene asked for more than the limit [s]
  double slewed = 0.0;                    ///< … or faster than it [s]
  double undefined = 0.0;                 ///< the scene had no answer [s]
  double contact = 0.0;                   ///< something was felt [s]
  double largestForce = 0.0;              ///< commanded [N]
  std::int64_t traceSamples = 0;          ///< kept in traces.db
  std::vector<Cut> cuts;
  std::vector<SafetyEvent> safety;       ///< what happened, and nothing else
  haptics::engine::Passivity passivity;  ///< as it was rendered: eq. (25)
  double deviceDamping = 0.0;            ///< of the mechanism itself [N·s/travel unit]
  double leastEnergy = 0.0;              ///< that a contact ever came down to [N·travel unit]
  haptics::devices::LinkReport link;     ///< what came over the device's wire, if it has one
  std::string deviceFault;               ///< why the device ended the trial, in words; or empty
  std::optional<ViewReport> view;        ///< how well it was seen; nothing where it was felt alone

  /// Whether what the participant felt may be relied on, and why (not).
  struct Judgement {
    Verdict verdict = Verdict::Pass;
    std::vector<base::Message> reasons;
  };
  Judgement judgement() const;
};

}  // namespace study
