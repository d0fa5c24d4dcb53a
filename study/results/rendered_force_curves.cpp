#include "study/results/rendered_force_curves.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include "analysis/hypothesis_tests/t_tests.h"
#include "haptics/engine/compiled_scene.h"
#include "haptics/engine/sample_ring.h"
#include "study/results/rendered_force_bins.h"
#include "study/storage/records.h"

namespace study {
namespace {

/// The intended force of a bone model at the travel of each point [N], without jitter: from its
/// force curve, or from its spheres before any is removed. Empty if the force depends on more than
/// travel.
std::vector<double> intendedForces(
    const haptics::engine::ModelSpec& modelSpec,
    const std::vector<RenderedForceCurve::Point>& points) {
  const auto model = haptics::engine::withoutNoiseAndRemoval(modelSpec);
  if (!model) return {};
  haptics::engine::CompiledScene compiled({.model = *model});
  const double coupling = haptics::engine::couplingOf(modelSpec);
  std::vector<double> forces;
  for (const auto& point : points) {
    // Where bone is removed, the tool lags behind the device by the stretch of the spring between
    // them (virtual coupling). The spring is several times as stiff as any bone, so that this
    // fixed-point iteration converges.
    double force = compiled.respond({.travel = point.travel}).force;
    for (int i = 0; coupling > 0.0 && i < 20; ++i) {
      force = compiled.respond({.travel = point.travel - force / coupling}).force;
    }
    forces.push_back(force);
  }
  return forces;
}

}  // namespace

std::vector<RenderedForceCurve> renderedForceCurves(Study& study, RunMode mode) {
  const storage::Records records(study.database());
  std::map<SessionId, std::string> counted;  // completed sessions and their participants
  for (const auto& session : records.sessions()) {
    if (session.runMode == mode && session.isCompleted())
      counted.emplace(session.id, session.participant);
  }
  const auto& protocol = study.protocol().protocol;
  const auto trials = records.trials();
  std::vector<RenderedForceCurve> curves;
  for (const auto& condition : protocol.conditions) {
    RenderedForceCurve curve{.condition = condition.id, .device = condition.device};
    const RenderedForceBins none(*protocol.device(condition.device)->kind, condition.scene());
    RenderedForceBins bins = none;
    std::map<std::string, RenderedForceBins> byParticipant;
    for (const auto& trial : trials) {
      const bool counts = trial.step.condition == condition.id && trial.step.isFinished() &&
                          !trial.step.isOptionalRepetition() &&
                          counted.count(trial.step.visit.session) > 0;
      if (!counts) continue;
      const auto samples = study.traces().read(trial.step.visit);
      bins.add(samples);
      byParticipant.try_emplace(counted.at(trial.step.visit.session), none)
          .first->second.add(samples);
      ++curve.trials;
    }
    curve.points = bins.points();
    curve.strokes = bins.strokes();
    for (auto& [participant, own] : byParticipant) curve.medians[participant] = own.medians();
    curve.intended = intendedForces(*condition.model, curve.points);
    curve.mostFeed = haptics::engine::largestFeedOf(condition.scene());
    if (curve.trials > 0) curves.push_back(std::move(curve));
  }
  return curves;
}

std::optional<double> rmsFromIntended(const RenderedForceCurve& curve) {
  if (curve.intended.empty() || curve.points.empty()) return std::nullopt;
  double sum = 0.0;
  for (std::size_t i = 0; i < curve.points.size(); ++i) {
    const double difference = curve.points[i].median - curve.intended[i];
    sum += difference * difference;  // not pow(), whose rounding depends on the compiler
  }
  return std::sqrt(sum / static_cast<double>(curve.points.size()));
}

std::optional<FeedLimited> feedLimitedIn(const RenderedForceCurve& curve) {
  std::optional<FeedLimited> found;
  for (std::size_t i = 0; i < curve.intended.size(); ++i) {
    const auto& point = curve.points[i];
    if (point.atMostFeed <= 0.5) continue;
    const double half = point.travel / (2.0 * point.bin + 1.0);  // of a bin
    if (!found) found = FeedLimited{.from = point.travel - half};
    found->to = point.travel + half;
    found->most = std::max(found->most, point.median - curve.intended[i]);
  }
  return found;
}

namespace {

using Medians = std::map<int, double>;  ///< median force, by bin [N]

Medians mediansOf(const RenderedForceCurve& curve) {
  Medians medians;
  for (const auto& point : curve.points) medians[point.bin] = point.median;
  return medians;
}

std::set<int> binsOfBoth(const Medians& a, const Medians& b) {
  std::set<int> bins;
  for (const auto& [bin, median] : a) {
    if (b.count(bin) > 0) bins.insert(bin);
  }
  return bins;
}

/// The root mean square difference over @p bins, which must be in @p a and in @p b; std::nullopt if
/// there are no bins.
std::optional<double> rmsDifference(const Medians& a, const Medians& b, const std::set<int>& bins) {
  if (bins.empty()) return std::nullopt;
  double sum = 0.0;
  for (const int bin : bins) {
    const double difference = a.at(bin) - b.at(bin);
    sum += difference * difference;
  }
  return std::sqrt(sum / static_cast<double>(bins.size()));
}

/// The medians for @p a and for @p b of each participant for whom they have a bin in common.
std::vector<std::pair<const Medians*, const Medians*>> pairsOf(
    const RenderedForceCurve& a, const RenderedForceCurve& b) {
  std::vector<std::pair<const Medians*, const Medians*>> pairs;
  for (const auto& [participant, medians] : a.medians) {
    const auto other = b.medians.find(participant);
    if (other == b.medians.end() || binsOfBoth(medians, other->second).empty()) continue;
    pairs.emplace_back(&medians, &other->second);
  }
  return pairs;
}

}  // namespace

std::vector<RenderedForceDifference> renderedForceDifferences(
    const std::vector<RenderedForceCurve>& curves) {
  std::vector<RenderedForceDifference> differences;
  for (std::size_t i = 0; i < curves.size(); ++i) {
    for (std::size_t j = i + 1; j < curves.size(); ++j) {
      const auto& a = curves[i];
      const auto& b = curves[j];
      if (a.device != b.device) continue;
      const auto medians = std::pair(mediansOf(a), mediansOf(b));
      const auto pairs = pairsOf(a, b);
      auto bins = binsOfBoth(medians.first, medians.second);
      for (const auto& [first, second] : pairs) {
        const auto passedBins = binsOfBoth(*first, *second);
        std::erase_if(bins, [&](int bin) { return passedBins.count(bin) == 0; });
      }
      const auto pooled = rmsDifference(medians.first, medians.second, bins);
      if (!pooled) continue;
      std::vector<double> own;
      for (const auto& [first, second] : pairs) {
        own.push_back(*rmsDifference(*first, *second, bins));
      }
      const auto test = analysis::pairedTTest(own, std::vector<double>(own.size(), 0.0));
      differences.push_back(
          {.condition1 = a.condition,
           .condition2 = b.condition,
           .pooled = *pooled,
           .participants = own.size(),
           .mean = test.meanDifference,
           .interval = confidenceInterval(test, 0.95)});
    }
  }
  return differences;
}

}  // namespace study
