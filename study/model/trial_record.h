#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "base/message.h"
#include "haptics/devices/device.h"
#include "haptics/engine/passivity.h"
#include "haptics/models/cut_detector.h"

namespace study {

/// How smoothly the scene of a trial was shown on the display.
struct ViewReport {
  std::string renderer;  ///< the graphics card, driver or software renderer that drew
  std::int64_t frames = 0;
  std::int64_t dropped = 0;    ///< refreshes, at the display's nominal rate, without a new picture
  double rate = 0.0;           ///< from the first frame to the last [1/s]
  double frameMedian = 0.0;    ///< median interval between frames [ms]
  double frameP99 = 0.0;       ///< 99th percentile of these intervals [ms]
  double latencyMedian = 0.0;  ///< from reading the device to the picture handed on [ms]
  double latencyP99 = 0.0;     ///< 99th percentile of that latency [ms]
  double period = 0.0;         ///< nominal interval between frames [ms]
  std::int64_t lostChanges = 0;  ///< updates of a reamed bone that were never drawn
};

/// The report as named values: {"frames", 512}, {"dropped", 3}, …
base::NamedArguments valuesOf(const ViewReport& view);

/// How a trial ended.
enum class TrialEnding {
  Finished,      ///< all cuts were made
  Stopped,       ///< stop was pressed
  DeviceGone,    ///< the device failed, and its force is off
  TraceLost,     ///< samples could not be stored
  TimedOut,      ///< too few cuts in the time allowed
  ProgramEnded,  ///< the program ended during the trial
};

std::string_view nameOf(TrialEnding ending) noexcept;
std::optional<TrialEnding> trialEndingNamed(std::string_view name) noexcept;

/// Why a force was changed or withheld, or what was wrong with it.
enum class SafetyKind {
  TooFast,          ///< the tool exceeded the velocity limit
  DeadManReleased,  ///< the dead-man switch was not held
  NoSample,         ///< the device gave no measurement
  MissedPeriods,    ///< no tick for more than one period
  SoftStart,        ///< the force was withheld until the scene asked for a small one, or was ramped
                    ///< up
  Saturated,        ///< the scene asked for more than the force limit
  Slewed,           ///< the scene asked for a faster change than the force rate limit
  NotFinite,        ///< the scene asked for a force that is not a finite number
  Active,           ///< the rendering gave more energy to the hand than it received
  Damped,           ///< damping was added to dissipate that energy
  TorqueSaturated,  ///< the scene asked for more than the torque limit
  TorqueSlewed,     ///< the scene asked for a faster change than the torque rate limit
  TorqueActive,     ///< the torque did net work on the hand, as a motor does
};

/// How often and for how long a safety function acted in a trial.
struct SafetyEvent {
  SafetyKind kind = SafetyKind::TooFast;
  std::int64_t times = 0;
  double duration = 0.0;  ///< total in the trial [s]
};

/// Whether the rendering of a trial was good enough for the study.
enum class Verdict { Pass, Warn, Fail };

std::string_view nameOf(Verdict verdict) noexcept;
std::optional<Verdict> verdictNamed(std::string_view name) noexcept;

/// Whether the share of late ticks exceeds 1 %, above which a trial gets a warning.
bool isOftenLate(std::int64_t lateTicks, std::int64_t ticks) noexcept;

/// The statistics of a device's link as named values: {"received", 5000}, {"lost", 2}, …
base::NamedArguments valuesOf(const haptics::devices::LinkReport& link);

/// The record of a trial: what was rendered, and how well.
struct TrialRecord {
  using Cut = haptics::models::CutDetector<double>::Cut;

  std::string device;        ///< its name as shown to people
  bool lacksDevice = false;  ///< the device was simulated, although somebody was to feel its force
  std::string travelUnit;
  TrialEnding ending = TrialEnding::Finished;
  double duration = 0.0;  ///< in simulated time: ticks / nominalRate [s]
  std::int64_t ticks = 0;
  double nominalRate = 1000.0;             ///< [Hz]
  std::optional<double> achievedRate;      ///< [Hz]; std::nullopt in simulated time
  std::optional<double> latenessMedian;    ///< median wake-up latency of the loop [µs]
  std::optional<double> latenessP99;       ///< 99th percentile of that latency [µs]
  std::optional<double> latenessLargest;   ///< largest latency [µs]
  std::optional<std::int64_t> lateTicks;   ///< ticks that began more than a period late
  std::optional<std::int64_t> hostPauses;  ///< late ticks that the host machine caused
  std::int64_t lostSamples = 0;            ///< samples dropped because the recorder's ring was full
  std::int64_t invalidTicks = 0;           ///< ticks in which the device gave no measurement
  double saturated = 0.0;     ///< time in which more force was asked for than the limit [s]
  double slewed = 0.0;        ///< time in which a faster change than the limit was asked for [s]
  double undefined = 0.0;     ///< time in which the scene gave no force [s]
  double contact = 0.0;       ///< time in which the force was more than 0.05 N [s]
  double largestForce = 0.0;  ///< largest commanded force [N]
  std::int64_t traceSamples = 0;  ///< number of samples stored in traces.db
  std::vector<Cut> cuts;
  std::vector<SafetyEvent> safety;       ///< only the kinds that occurred
  haptics::engine::Passivity passivity;  ///< of the rendering: eq. (25) of the punch paper
  double deviceDamping = 0.0;            ///< physical damping of the mechanism [N·s/travel unit]
  double leastEnergy = 0.0;              ///< smallest energy balance of a contact [N·travel unit]
  haptics::devices::LinkReport link;     ///< statistics of the device's wire, if it has one
  bool hasTorque = false;                ///< the scene has a torque about the tool's axis
  bool isTorqueRendered = false;         ///< the device rendered that torque
  double torqueSaturated = 0.0;          ///< `saturated` of the torque [s]
  double largestTorque = 0.0;            ///< largest commanded torque [N·m]
  double leastRotationEnergy = 0.0;      ///< leastEnergy of the rotation [J]
  std::string deviceFault;  ///< why the device ended the trial, a text for the operator; or empty
  std::optional<ViewReport> view;  ///< how smoothly the scene was shown, if it was

  /// Whether the rendering of the trial was valid, with the reasons.
  struct Judgement {
    Verdict verdict = Verdict::Pass;
    std::vector<base::Message> reasons;
  };
  Judgement judgement() const;
};

}  // namespace study
