#include "study/felt_curves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/tick_sample.h"
#include "study/storage/records.h"

namespace study {
namespace {

constexpr int kBins = 80;
constexpr std::size_t kFewest = 20;  // samples in a bin that say something

/// Forces by bins of travel.
class Bins {
 public:
  explicit Bins(double most) : width_(most / kBins), forces_(kBins) {}

  void add(const std::vector<storage::TraceSample>& samples) {
    using haptics::engine::TickSample;
    const double closing = 5.0 * width_;  // [units/s]: slower is no movement
    for (const auto& sample : samples) {
      const bool isBad = (sample.marks & (TickSample::Invalid | TickSample::Stopped)) != 0;
      if (isBad || static_cast<double>(sample.velocity) < closing) continue;
      const auto bin = static_cast<std::int64_t>(std::floor(sample.travel / width_));
      if (bin >= 0 && bin < kBins) forces_[static_cast<std::size_t>(bin)].push_back(sample.force);
    }
  }

  std::vector<FeltCurve::Point> points() {
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

 private:
  double width_;
  std::vector<std::vector<float>> forces_;
};

double mostTravelOf(haptics::devices::DeviceKind kind) {
  return kind == haptics::devices::DeviceKind::Punch ? 11.0 : 0.02;
}

/// What a bone is meant to feel like at the travel of each point: its curve, or its spheres before
/// any is gone, without jitter. Nothing for what depends on more than travel.
std::vector<double> meantForces(
    haptics::engine::SceneSpec scene, const std::vector<FeltCurve::Point>& points) {
  if (!haptics::engine::isBone(scene)) return {};
  if (auto* packing = std::get_if<haptics::engine::PackingSpec>(&scene.model)) {
    packing->isRemoved = false;
  } else {
    std::get<haptics::engine::MaterialSpec>(scene.model).jitter = {};
  }
  haptics::engine::CompiledScene compiled(scene);
  std::vector<double> forces;
  for (const auto& point : points) {
    forces.push_back(compiled.respond({.travel = point.travel}).force);
  }
  return forces;
}

}  // namespace

std::vector<FeltCurve> feltCurves(Study& study, RunMode mode) {
  const storage::Records records(study.database());
  std::set<SessionId> counted;
  for (const auto& session : records.sessions()) {
    if (session.runMode == nameOf(mode) && session.status == "completed")
      counted.insert(session.id);
  }
  const auto& protocol = study.protocol().protocol;
  const auto trials = records.trials();
  std::vector<FeltCurve> curves;
  for (const auto& condition : protocol.conditions) {
    FeltCurve curve{.condition = condition.id, .device = condition.device};
    Bins bins(mostTravelOf(protocol.device(condition.device)->kind));
    for (const auto& trial : trials) {
      const bool counts = trial.step.condition == condition.id &&
                          trial.step.visitStatus == "finished" &&
                          counted.count(trial.step.visit.session) > 0;
      if (!counts) continue;
      bins.add(study.traces().read(trial.step.visit));
      curve.travelUnit = trial.travelUnit;
      ++curve.trials;
    }
    curve.points = bins.points();
    auto scene = condition.scene;
    scene.device = protocol.device(condition.device)->kind;
    curve.meant = meantForces(std::move(scene), curve.points);
    if (curve.trials > 0) curves.push_back(std::move(curve));
  }
  return curves;
}

std::optional<double> rmsFromMeant(const FeltCurve& curve) {
  if (curve.meant.empty()) return std::nullopt;
  double sum = 0.0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    sum += std::pow(curve.points[i].median - curve.meant[i], 2.0);
  }
  return std::sqrt(sum / static_cast<double>(curve.points.size()));
}

std::optional<double> rmsDifference(const FeltCurve& a, const FeltCurve& b) {
  std::map<double, double> medians;
  for (const auto& point : a.points) medians[point.travel] = point.median;
  double sum = 0.0;
  int count = 0;
  for (const auto& point : b.points) {
    const auto other = medians.find(point.travel);
    if (other == medians.end() || a.device != b.device) continue;
    sum += (point.median - other->second) * (point.median - other->second);
    ++count;
  }
  return count == 0 ? std::nullopt : std::optional(std::sqrt(sum / count));
}

}  // namespace study
