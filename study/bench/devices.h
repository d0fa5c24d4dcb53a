#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/bench/device_link.h"

namespace study::bench {

/// Measurements of a device on its link. There is one run for each time that the device was armed;
/// more than one if the device failed and was connected again.
struct LinkSeries {
  std::string device;  ///< "punch", "arm"
  double rate = 0.0;   ///< nominal rate of samples [Hz]
  std::vector<haptics::bench::LinkRun> runs;
  std::uint64_t sent = 0;  ///< number of samples that the emulator sent during the runs

  double seconds() const;                          ///< total duration of the runs
  const haptics::bench::LinkRun& longest() const;  ///< requires at least one run
  /// The sum of a count over the runs.
  std::uint64_t sum(std::uint64_t haptics::devices::LinkReport::*of) const;
  std::int64_t faults() const;  ///< number of failures
};

/// Numbers of faults on the link, by kind: injected by an emulator, or detected by the device.
struct FrameFaults {
  static constexpr std::array<std::string_view, 4> kNames{"drop", "double", "reorder", "damage"};
  std::array<std::int64_t, kNames.size()> of{};
};

/// Stalls of the loop with equal durations.
struct StallSeries {
  LinkSeries link;
  double duration = 0.0;       ///< duration of each stall [ms]
  int stalls = 0;              ///< number of stalls
  std::vector<double> forces;  ///< force at the beginning of each stall that began with a force [N]
  std::vector<double> motorOffAfter;  ///< time from the stall's beginning until the device switched
                                      ///< its force off [ms]
  int disarmed = 0;                   ///< number of stalls after which the device was disarmed
};

/// Injected and detected faults of one device.
struct FaultCounts {
  std::string device;
  FrameFaults injected;  ///< by the emulator
  FrameFaults found;     ///< by the device
  int repeated = 0;      ///< number of blocks of 100 faults that were repeated because the device
                         ///< failed
};

/// The results of measureDevices().
struct DeviceMeasurement {
  std::vector<LinkSeries> together;  ///< both devices at the same time
  std::vector<StallSeries> stalls;
  std::vector<LinkSeries> sweep;  ///< one device at a time, at several rates
  std::vector<FaultCounts> counts;
  bool isExact() const;  ///< whether as many faults were detected as were injected
};

/// The options of measureDevices().
struct DeviceBenchOptions {
  double seconds = 20.0;           ///< duration of "together"; other parts are shorter [s]
  int faults = 1000;               ///< number of each kind
  std::vector<std::string> parts;  ///< names in kDeviceBenchParts; empty: all
};

/// The parts of the measurement, in the order of DeviceMeasurement's members.
inline constexpr std::array<const char*, 4> kDeviceBenchParts{
    "together", "stalls", "rates", "counts"};

/// Starts emulators in separate processes, and measures a loop of this program with them.
/// @throws UserError, haptics::devices::DeviceError  if no emulator can be started.
DeviceMeasurement measureDevices(const DeviceBenchOptions& options);

}  // namespace study::bench
