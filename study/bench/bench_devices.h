#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/bench/device_link.h"
#include "study/bench/bench_report.h"

namespace study::app {

/// A device on its wire over a while: a run for each time that it was armed, more than one where it
/// had failed and was connected anew.
struct LinkSeries {
  std::string device;           ///< "punch", "arm"
  double rate = 0.0;            ///< of its samples [Hz]
  bool isDeviceUrgent = false;  ///< the stand-in had real-time priority
  std::vector<haptics::bench::LinkRun> runs;
  std::uint64_t sent = 0;  ///< samples that the stand-in has made meanwhile

  double seconds() const;                          ///< of ticking
  const haptics::bench::LinkRun& longest() const;  ///< there is one
  std::uint64_t sum(std::uint64_t haptics::devices::LinkReport::*of) const;
  std::vector<std::string> faults() const;  ///< in words, as they came
};

/// What was done to frames, or found.
struct FrameFaults {
  static constexpr std::array<std::string_view, 4> kNames{"drop", "double", "reorder", "damage"};
  std::array<std::int64_t, kNames.size()> of{};
};

/// The loop stood still, several times.
struct StallSeries {
  LinkSeries link;
  double duration = 0.0;  ///< of each [ms]
  int stalls = 0;
  std::vector<double> forces;      ///< where there was one at its beginning [N]
  std::vector<double> letGoAfter;  ///< where it did, from the stall's beginning [ms]
  int disarmed = 0;                ///< stalls after which it took no more forces
  std::vector<std::string> ends;   ///< what the arm's controller said of them
  FrameFaults injected;
  FrameFaults found;
};

struct FaultCounts {
  std::string device;
  FrameFaults injected;
  FrameFaults found;
  int repeated = 0;  ///< hundreds that were done again, since the device had failed in them
};

struct DeviceMeasurement {
  std::vector<LinkSeries> together;
  std::vector<StallSeries> stalls;
  std::vector<LinkSeries> sweep;
  std::vector<FaultCounts> counts;
  bool isExact() const;
};

struct DeviceBenchOptions {
  double seconds = 20.0;           ///< of both devices at once; the other parts take less
  int faults = 1000;               ///< of each kind
  std::vector<std::string> parts;  ///< none: all
};

inline constexpr std::array<const char*, 4> kDeviceBenchParts{
    "together", "stalls", "rates", "counts"};

/// Starts stand-ins for devices as processes of their own, and measures what a loop of ours makes
/// of them.
/// @throws UserError  or what devices throw, where no stand-in can be had.
DeviceMeasurement measureDevices(const DeviceBenchOptions& options);

report::Document devicesReport(const DeviceMeasurement& measured);
std::vector<Target> devicesTargets(const DeviceMeasurement& measured);

}  // namespace study::app
