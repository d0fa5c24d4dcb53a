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

/// Forces of a tool that closes or advances, by bins of travel: an eightieth of the device's travel
/// each.
///
/// What counts as closing is how the hand of that trial moved: faster than a tenth of its own
/// closing speed (the 95th percentile of its samples that close against a force), or than a
/// sixteenth of the device's travel in a second, whichever is slower. Reaming at 0.01 mm/s, as it
/// was measured, counts as well as a stroke of 30 mm/s; a hand that rests does not.
class FeltBins {
 public:
  /// Bins of the travel that the device has, or that the data of @p scene reach, whichever is more.
  FeltBins(const haptics::devices::DeviceKind& kind, const haptics::engine::SceneSpec& scene);

  /// The samples of a trial; those that were not felt are left out.
  void add(std::span<const storage::TraceSample> samples);

  /// The middle sample of every bin that was felt [N].
  std::map<int, double> medians();

  /// Of every bin with 20 samples or more.
  std::vector<FeltCurve::Point> points();

 private:
  double width_;    ///< [device's travel unit]
  double closing_;  ///< no slower than this is ever asked for [unit/s]
  std::vector<std::vector<float>> forces_;
};

}  // namespace study
