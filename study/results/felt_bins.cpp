#include "study/results/felt_bins.h"

#include <algorithm>
#include <cmath>

#include "haptics/engine/sample_ring.h"

namespace study {
namespace {

constexpr int kBins = 80;            // of the device's own travel
constexpr std::size_t kFewest = 20;  // samples in a bin that say something
constexpr double kOwnSpeed = 0.95;   // which quantile of the closing samples is the hand's speed
constexpr double kShareOfOwn = 0.1;  // of it, below which a hand rests
constexpr double kSlowestStroke = 16.0;  // [s] that a closure of all the travel takes at most

using haptics::engine::TickSample;

bool isFelt(const storage::TraceSample& sample) noexcept {
  return (sample.marks & (TickSample::Invalid | TickSample::Stopped)) == 0;
}

/// Where the data of a scene end, without the ramp behind them.
double endOf(const haptics::engine::SceneSpec& scene) {
  const auto parts = haptics::engine::partsOf(scene.model);
  if (parts.cut != nullptr && !parts.cut->curve.empty()) return parts.cut->curve.back().travel;
  return haptics::engine::endOfData(scene.model).value_or(0.0);
}

/// At which the hand closed against a force in these samples [unit/s]; 0 where it never did. What
/// it does in the air does not count: it may come fast and ream slowly.
double ownSpeed(std::span<const storage::TraceSample> samples) {
  std::vector<float> speeds;
  for (const auto& sample : samples) {
    if (isFelt(sample) && sample.velocity > 0.0F && sample.force > 0.0F)
      speeds.push_back(sample.velocity);
  }
  if (speeds.empty()) return 0.0;
  const auto place = speeds.begin() + static_cast<std::ptrdiff_t>(
                                          kOwnSpeed * static_cast<double>(speeds.size() - 1));
  std::nth_element(speeds.begin(), place, speeds.end());
  return *place;
}

}  // namespace

FeltBins::FeltBins(
    const haptics::devices::DeviceKind& kind, const haptics::engine::SceneSpec& scene)
    : width_(kind.travel.most / kBins), closing_(kind.travel.most / kSlowestStroke) {
  const double most = std::max(kind.travel.most, endOf(scene));
  // A little less, so that rounding adds no bin.
  forces_.resize(static_cast<std::size_t>(std::ceil(most / width_ - 1e-9)));
}

void FeltBins::add(std::span<const storage::TraceSample> samples) {
  const double closing = std::min(closing_, kShareOfOwn * ownSpeed(samples));
  for (const auto& sample : samples) {
    const auto velocity = static_cast<double>(sample.velocity);
    if (!isFelt(sample) || !(velocity > 0.0) || velocity < closing) continue;
    const double bin = std::floor(static_cast<double>(sample.travel) / width_);
    if (!(bin >= 0.0 && bin < static_cast<double>(forces_.size()))) continue;
    forces_[static_cast<std::size_t>(bin)].push_back(sample.force);
  }
}

std::map<int, double> FeltBins::medians() {
  std::map<int, double> medians;
  for (std::size_t bin = 0; bin < forces_.size(); ++bin) {
    auto& forces = forces_[bin];
    if (forces.empty()) continue;
    const auto middle = forces.begin() + static_cast<std::ptrdiff_t>((forces.size() - 1) / 2);
    std::nth_element(forces.begin(), middle, forces.end());
    medians[static_cast<int>(bin)] = *middle;
  }
  return medians;
}

std::vector<FeltCurve::Point> FeltBins::points() {
  std::vector<FeltCurve::Point> points;
  for (std::size_t bin = 0; bin < forces_.size(); ++bin) {
    auto& forces = forces_[bin];
    if (forces.size() < kFewest) continue;
    std::sort(forces.begin(), forces.end());
    const auto at = [&](double share) {
      return static_cast<double>(
          forces[static_cast<std::size_t>(share * static_cast<double>(forces.size() - 1))]);
    };
    points.push_back({(static_cast<double>(bin) + 0.5) * width_, at(0.1), at(0.5), at(0.9)});
  }
  return points;
}

}  // namespace study
