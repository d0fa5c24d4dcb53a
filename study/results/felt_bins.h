#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "haptics/devices/device_kind.h"
#include "haptics/engine/scene_spec.h"
#include "study/results/felt_curves.h"
#include "study/storage/trace_store.h"

namespace study {

/// Forces while a tool closes or advances, in bins of travel: each an eightieth of the device's
/// travel. Each stroke counts once in each bin that it passed, with its own median there, however
/// fast it was. Where it passed a bin between two samples, the force is on the line between them.
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

  /// Adds the strokes of a trial; samples without a force are left out.
  void add(std::span<const storage::TraceSample> samples);

  /// The median over strokes in every bin that one passed [N].
  std::map<int, double> medians();

  /// The same bins, with percentiles over strokes.
  std::vector<FeltCurve::Point> points();

 private:
  using Stroke = std::map<std::size_t, std::vector<float>>;  ///< its forces, by bin [N]

  std::optional<std::size_t> binOf(double travel) const;
  double middleOf(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * width_; }
  void addBetween(
      const storage::TraceSample& a, const storage::TraceSample& b, Stroke& stroke) const;
  void endStroke(Stroke& stroke);

  double width_;                            ///< [device's travel unit]
  double closing_;                          ///< threshold; this is its largest value [unit/s]
  std::vector<std::vector<float>> forces_;  ///< of each stroke, by bin [N]
};

}  // namespace study
