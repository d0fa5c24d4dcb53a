#include "study/results/rendered_force_bins.h"

#include <algorithm>
#include <cmath>

#include "haptics/engine/sample_ring.h"

namespace study {
namespace {

constexpr int kBins = 80;                       // over the device's whole travel
constexpr double kClosingSpeedQuantile = 0.95;  // quantile of closing speeds that is used as the
                                                // hand's speed
constexpr double kThresholdPerHandSpeed = 0.1;  // closing threshold as a share of the hand's speed
/// Share of the largest feed that counts as reaching it: where the force falls, the device is a
/// little slower than the tool, because the spring between them relaxes.
constexpr double kReachesFeed = 0.9;
constexpr double kSlowestStroke = 16.0;  // [s] for the whole travel: bounds the closing threshold
                                         // from above

using haptics::engine::TickSample;

constexpr auto kStrokeEnds =
    static_cast<std::uint8_t>(haptics::models::CutDetector<double>::Event::CutCompleted);

bool isFelt(const storage::TraceSample& sample) noexcept {
  return (sample.marks & (TickSample::Invalid | TickSample::Stopped)) == 0;
}

/// The travel at which a scene's data end, before its final ramp.
double endOf(const haptics::engine::SceneSpec& scene) {
  const auto parts = haptics::engine::partsOf(scene.model);
  if (parts.cut != nullptr && !parts.cut->curve.empty()) return parts.cut->curve.back().travel;
  return haptics::engine::endOfData(scene.model).value_or(0.0);
}

/// The lower of the two middle values if their number is even, so that the median is a force that
/// was commanded.
/// @param values  not empty.
float lowerMedian(std::vector<float>& values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>((values.size() - 1) / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

/// The hand's speed while it closed against a force in these samples [unit/s]; 0 if it never did.
/// Movement without a force is left out, because it may be much faster than reaming.
double handSpeed(std::span<const storage::TraceSample> samples) {
  std::vector<float> speeds;
  for (const auto& sample : samples) {
    if (isFelt(sample) && sample.velocity > 0.0F && sample.force > 0.0F)
      speeds.push_back(sample.velocity);
  }
  if (speeds.empty()) return 0.0;
  const auto place =
      speeds.begin() +
      static_cast<std::ptrdiff_t>(kClosingSpeedQuantile * static_cast<double>(speeds.size() - 1));
  std::nth_element(speeds.begin(), place, speeds.end());
  return *place;
}

}  // namespace

RenderedForceBins::RenderedForceBins(
    const haptics::devices::DeviceKind& kind, const haptics::engine::SceneSpec& scene)
    : width_(kind.travel.most / kBins),
      largestClosingThreshold_(kind.travel.most / kSlowestStroke),
      mostFeed_(haptics::engine::largestFeedOf(scene)) {
  const double most = std::max(kind.travel.most, endOf(scene));
  // The small number keeps rounding errors from adding a bin.
  forces_.resize(static_cast<std::size_t>(std::ceil(most / width_ - 1e-9)));
  atMostFeed_.resize(forces_.size());
}

void RenderedForceBins::add(std::span<const storage::TraceSample> samples) {
  const double closing =
      std::min(largestClosingThreshold_, kThresholdPerHandSpeed * handSpeed(samples));
  Stroke stroke;
  // the previous sample, if the tool was closing then; otherwise nullptr
  const storage::TraceSample* previousClosing = nullptr;
  for (const auto& sample : samples) {
    const auto velocity = static_cast<double>(sample.velocity);
    const bool closes = isFelt(sample) && velocity > 0.0 && velocity >= closing;
    if (closes) {
      if (const auto bin = binOf(sample.travel)) {
        stroke[*bin].forces.push_back(sample.force);
        stroke[*bin].speeds.push_back(sample.velocity);
      }
      if (previousClosing != nullptr) addBetween(*previousClosing, sample, stroke);
    }
    previousClosing = closes ? &sample : nullptr;
    if (sample.landmark == kStrokeEnds) endStroke(stroke);
  }
  endStroke(stroke);
}

std::optional<std::size_t> RenderedForceBins::binOf(double travel) const {
  const double bin = std::floor(travel / width_);
  if (!(bin >= 0.0 && bin < static_cast<double>(forces_.size()))) return std::nullopt;
  return static_cast<std::size_t>(bin);
}

/// Adds a force, interpolated linearly between @p a and @p b, to the bins that the tool passed
/// between these samples.
void RenderedForceBins::addBetween(
    const storage::TraceSample& a, const storage::TraceSample& b, Stroke& stroke) const {
  const auto first = binOf(a.travel);
  const auto last = binOf(b.travel);
  if (!first || !last) return;
  for (std::size_t bin = *first + 1; bin < *last; ++bin) {
    const double share = (middleOf(bin) - a.travel) / (static_cast<double>(b.travel) - a.travel);
    stroke[bin].forces.push_back(static_cast<float>(std::lerp(a.force, b.force, share)));
    stroke[bin].speeds.push_back(b.velocity);
  }
}

void RenderedForceBins::endStroke(Stroke& stroke) {
  for (auto& [bin, passed] : stroke) {
    forces_[bin].push_back(lowerMedian(passed.forces));
    const auto speed = static_cast<double>(lowerMedian(passed.speeds));
    if (speed >= kReachesFeed * mostFeed_) ++atMostFeed_[bin];
  }
  stroke.clear();
}

std::map<int, double> RenderedForceBins::medians() {
  std::map<int, double> medians;
  for (std::size_t bin = 0; bin < forces_.size(); ++bin) {
    if (!forces_[bin].empty()) medians[static_cast<int>(bin)] = lowerMedian(forces_[bin]);
  }
  return medians;
}

std::size_t RenderedForceBins::strokes() const {
  std::size_t most = 0;
  for (const auto& forces : forces_) most = std::max(most, forces.size());
  return most;
}

std::vector<RenderedForceCurve::Point> RenderedForceBins::points() {
  std::vector<RenderedForceCurve::Point> points;
  const auto all = strokes();
  for (std::size_t bin = 0; bin < forces_.size(); ++bin) {
    auto& forces = forces_[bin];
    if (forces.empty() || 2 * forces.size() < all) continue;
    std::ranges::sort(forces);
    const auto at = [&](double share) {
      return static_cast<double>(
          forces[static_cast<std::size_t>(share * static_cast<double>(forces.size() - 1))]);
    };
    points.push_back(
        {.travel = middleOf(bin),
         .low = at(0.1),
         .median = at(0.5),
         .high = at(0.9),
         .bin = static_cast<int>(bin),
         .atMostFeed = static_cast<double>(atMostFeed_[bin]) / static_cast<double>(forces.size())});
  }
  return points;
}

}  // namespace study
