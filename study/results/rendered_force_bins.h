#pragma once

#include <cstddef>
#include <map>
#include <optional>
#include <span>
#include <vector>

#include "haptics/devices/device_kind.h"
#include "haptics/engine/scene_spec.h"
#include "study/results/rendered_force_curves.h"
#include "study/storage/trace_store.h"

namespace study {

/// Commanded forces while a tool closes or advances, in bins of travel, each 1/80 of the device's
/// travel. Each stroke counts once in each bin that it passed, with the median of its forces in the
/// bin, regardless of its speed. In a bin without a sample, the force is interpolated linearly
/// between the two nearest samples.
///
/// A sample counts as closing if the tool is faster than a threshold. The threshold is the smaller
/// of two speeds: a tenth of the hand's closing speed in that trial (the 95th percentile over the
/// samples that close against a force), and a sixteenth of the device's travel per second.
/// Therefore both reaming at 0.01 mm/s, as in the measurements, and a stroke of 30 mm/s count as
/// closing; a hand at rest does not.
class RenderedForceBins {
 public:
  /// Bins over the device's travel, or over the data of @p scene if they extend beyond the travel.
  RenderedForceBins(
      const haptics::devices::DeviceKind& kind, const haptics::engine::SceneSpec& scene);

  /// Adds the strokes of a trial; samples without a force are left out.
  void add(std::span<const storage::TraceSample> samples);

  /// The median over strokes for every bin that a stroke passed, by the number of the bin [N].
  std::map<int, double> medians();

  /// The median, 10th and 90th percentile over strokes, of the bins that at least half as many
  /// strokes passed as the bin that most of them passed. Beyond, a few deep strokes would be taken
  /// for the curve of all.
  std::vector<RenderedForceCurve::Point> points();

  /// How many strokes passed the bin that most of them passed.
  std::size_t strokes() const;

 private:
  /// What one stroke gave in a bin.
  struct Passed {
    std::vector<float> forces;  ///< [N]
    std::vector<float> speeds;  ///< [device's travel unit/s]
  };
  using Stroke = std::map<std::size_t, Passed>;  ///< by bin

  /// The bin of a travel; std::nullopt outside of all bins.
  std::optional<std::size_t> binOf(double travel) const;
  /// The travel in the middle of a bin [device's travel unit].
  double middleOf(std::size_t bin) const { return (static_cast<double>(bin) + 0.5) * width_; }
  void addBetween(
      const storage::TraceSample& a, const storage::TraceSample& b, Stroke& stroke) const;
  /// Adds the median force of each bin that the stroke passed, and clears the stroke.
  void endStroke(Stroke& stroke);

  double width_;                            ///< [device's travel unit]
  double largestClosingThreshold_;          ///< upper bound of the closing threshold [unit/s]
  double mostFeed_;                         ///< of the scene [m/s]; infinite: no limit
  std::vector<std::vector<float>> forces_;  ///< of each stroke, by bin [N]
  std::vector<std::size_t> atMostFeed_;     ///< strokes that reached mostFeed_, by bin
};

}  // namespace study
