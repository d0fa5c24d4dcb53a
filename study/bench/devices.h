#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "haptics/bench/device_link.h"

namespace study::bench {

/// A device on its wire over a while: a run for each time that it was armed; more than one where it
/// failed and was connected again.
struct LinkSeries {
  std::string device;  ///< "punch", "arm"
  double rate = 0.0;   ///< of its samples [Hz]
  std::vector<haptics::bench::LinkRun> runs;
  std::uint64_t sent = 0;  ///< samples that the emulator has made meanwhile

  double seconds() const;                          ///< of ticking
  const haptics::bench::LinkRun& longest() const;  ///< there is one
  std::uint64_t sum(std::uint64_t haptics::devices::LinkReport::*of) const;
  std::int64_t faults() const;  ///< how often it failed
};

/// Faults on the wire: injected by an emulator, or found by the device.
struct FrameFaults {
  static constexpr std::array<std::string_view, 4> kNames{"drop", "double", "reorder", "damage"};
  std::array<std::int64_t, kNames.size()> of{};
};

/// The loop stood still, several times.
struct StallSeries {
  LinkSeries link;
  double duration = 0.0;  ///< of each [ms]
  int stalls = 0;
  std::vector<double> forces;      ///< at its beginning, where there was one [N]
  std::vector<double> letGoAfter;  ///< when the device let go, from its beginning [ms]
  int disarmed = 0;                ///< stalls after which the device took no more forces
};

struct FaultCounts {
  std::string device;
  FrameFaults injected;
  FrameFaults found;
  int repeated = 0;  ///< hundreds that were done again, because the device failed in them
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

/// Starts emulators as processes of their own, and measures a loop of this program with them.
/// @throws UserError, haptics::devices::DeviceError  if no emulator can be started.
DeviceMeasurement measureDevices(const DeviceBenchOptions& options);

}  // namespace study::bench
