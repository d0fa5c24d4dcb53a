#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/bench/device_link.h"

namespace study::bench {

/// Measurements of a device on its connection: one run for each time it was armed. There is more
/// than one if the device failed and was connected again.
struct LinkSeries {
  std::string device;  ///< "punch", "arm"
  double rate = 0.0;   ///< rate of its samples [Hz]
  std::vector<haptics::bench::LinkRun> runs;
  std::uint64_t sent = 0;  ///< samples that the emulator sent meanwhile

  double seconds() const;                          ///< total duration of the runs
  const haptics::bench::LinkRun& longest() const;  ///< there is at least one
  std::uint64_t sum(std::uint64_t haptics::devices::LinkReport::*of) const;
  std::int64_t faults() const;  ///< number of failures
};

/// Numbers of faults on the wire: injected by an emulator, or detected by the device.
struct FrameFaults {
  static constexpr std::array<std::string_view, 4> kNames{"drop", "double", "reorder", "damage"};
  std::array<std::int64_t, kNames.size()> of{};
};

/// Stalls of the loop, all of the same duration.
struct StallSeries {
  LinkSeries link;
  double duration = 0.0;  ///< of each [ms]
  int stalls = 0;
  std::vector<double> forces;  ///< force at the beginning of each stall, if there was one [N]
  std::vector<double> motorOffAfter;  ///< time from the stall's beginning until the device switched
                                      ///< its force off [ms]
  int disarmed = 0;                   ///< number of stalls after which the device was disarmed
};

struct FaultCounts {
  std::string device;
  FrameFaults injected;
  FrameFaults found;
  int repeated = 0;  ///< blocks of 100 faults that were repeated because the device failed
};

struct DeviceMeasurement {
  std::vector<LinkSeries> together;
  std::vector<StallSeries> stalls;
  std::vector<LinkSeries> sweep;
  std::vector<FaultCounts> counts;
  bool isExact() const;
};

struct DeviceBenchOptions {
  double seconds = 20.0;           ///< of both devices together; the other parts take less [s]
  int faults = 1000;               ///< of each kind
  std::vector<std::string> parts;  ///< empty: all
};

inline constexpr std::array<const char*, 4> kDeviceBenchParts{
    "together", "stalls", "rates", "counts"};

/// Starts emulators in their own processes, and measures a loop of this program with them.
/// @throws UserError, haptics::devices::DeviceError  if no emulator can be started.
DeviceMeasurement measureDevices(const DeviceBenchOptions& options);

}  // namespace study::bench
