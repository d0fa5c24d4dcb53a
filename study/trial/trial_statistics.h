#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "haptics/engine/force_engine.h"
#include "study/model/trial_record.h"

namespace study {

/// Counts what happens in a trial while it is recorded.
class TrialStatistics {
 public:
  /// @param rate  of the ticks [Hz].
  TrialStatistics(const haptics::devices::DeviceKind& device, double rate);

  void add(const haptics::engine::TickSample& sample);

  /// Writes the results into @p record, except for those of clocks and traces.
  void fillIn(TrialRecord& record) const;

 private:
  double rate_;
  haptics::engine::CutDetector detector_;
  std::vector<TrialRecord::Cut> cuts_;
  std::int64_t ticks_ = 0;
  std::int64_t invalid_ = 0;
  std::int64_t saturated_ = 0;
  std::int64_t slewed_ = 0;
  std::int64_t undefined_ = 0;
  std::int64_t contact_ = 0;
  void count(SafetyKind kind, bool isNow);

  struct Tally {
    std::int64_t times = 0;
    std::int64_t ticks = 0;
    bool wasBefore = false;
  };

  double largestForce_ = 0.0;
  double leastEnergy_ = 0.0;
  std::int64_t torqueSaturated_ = 0;
  double largestTorque_ = 0.0;
  double leastTurnEnergy_ = 0.0;
  std::array<Tally, 13> tallies_{};  ///< by SafetyKind
};

}  // namespace study
