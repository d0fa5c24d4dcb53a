#pragma once

#include <cstddef>
#include <map>
#include <span>
#include <vector>

#include "haptics/devices/device_kind.h"
#include "haptics/engine/scene_spec.h"
#include "study/results/felt_curves.h"
#include "study/storage/trace_store.h"

namespace study {

/// Forces while a tool closes or advances, in bins of travel: each an eightieth of the device's
/// travel.
///
/// A sample counts as closing if the tool is faster than a threshold. The threshold is a tenth of
/// the hand's own closing speed in that trial (the 95th percentile of its samples that close
/// against a force), or a sixteenth of the device's travel per second, whichever is slower. Reaming
/// at 0.01 mm/s, as in the measurements, therefore counts as well as a stroke of 30 mm/s; a hand at
/// rest does not.
class FeltBins {
 public:
  /// Bins over the device's travel, or over the data of @p scene if these reach farther.
  FeltBins(const haptics::devices::DeviceKind& kind, const haptics::engine::SceneSpec& scene);

  /// Adds the samples of a trial; those without a force are left out.
  void add(std::span<const storage::TraceSample> samples);

  /// The median force of every bin that has samples [N].
  std::map<int, double> medians();

  /// The bins with 20 samples or more.
  std::vector<FeltCurve::Point> points();

 private:
  double width_;    ///< [device's travel unit]
  double closing_;  ///< threshold; this is its largest value [unit/s]
  std::vector<std::vector<float>> forces_;
};

}  // namespace study
