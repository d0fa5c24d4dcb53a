#include "analysis/planning/site_power.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <span>
#include <stdexcept>
#include <vector>

#include "analysis/models/meta_analysis.h"
#include "analysis/numerics/distributions.h"
#include "analysis/planning/power.h"

namespace analysis {
namespace {

/// @throws std::invalid_argument  with too few participants for two at each site.
void checkSites(const SitePlan& plan, std::uint64_t participants) {
  plan.check();
  if (participants < plan.fewestParticipants()) {
    throw std::invalid_argument("each site needs two participants");
  }
}

/// Participants of a site with their sums of answers: [participant][condition].
using SiteSums = std::vector<std::vector<int>>;

/// One simulated study at several sites.
class SimulatedSiteStudy {
 public:
  SimulatedSiteStudy(const PowerSimulation& simulation, const SitePlan& plan)
      : conditions_(static_cast<std::size_t>(simulation.model.conditions)),
        answers_(simulation.model.answers),
        level_(simulation.alphaPerTest),
        pooledLevel_(1.0 - simulation.alpha),
        deviation_(plan.deviation),
        criticalT_(StudentDistribution(static_cast<double>(simulation.participants - 1))
                       .twoSidedQuantile(level_)),
        sites_(plan.sites) {
    const auto participantsPerSite = simulation.participants / plan.sites;
    const auto more = simulation.participants % plan.sites;
    for (std::size_t j = 0; j < sites_.size(); ++j)
      sites_[j].resize(participantsPerSite + (j < more ? 1 : 0));
  }

  void draw(LikertCohort& cohort) {
    for (auto& site : sites_) {
      const auto shifts = cohort.drawSiteShifts(deviation_);
      for (auto& sums : site) {
        sums.clear();
        for (const auto& of : cohort.next(shifts)) {
          sums.push_back(std::accumulate(of.begin(), of.end(), 0));
        }
      }
    }
  }

  /// The pooled difference, with its interval at 1 − alpha of the family; std::nullopt for too few
  /// sites.
  std::optional<PooledEstimate> pooledDifference(std::size_t a, std::size_t b) const {
    std::vector<EstimateWithError> known;
    for (const auto& site : sites_) {
      const auto [n, mean, spread] = momentsOf(std::span(&site, 1), a, b);
      if (spread > 0.0) known.push_back({mean, std::sqrt(spread / (n * (n - 1.0)))});
    }
    if (known.size() < 2) return std::nullopt;
    return pooledToFourDigits(known, pooledLevel_);
  }

  bool isDetected(const std::optional<PooledEstimate>& difference) const {
    return difference && difference->p <= level_;
  }

  bool pairedT(std::size_t a, std::size_t b) const {
    const auto [n, mean, spread] = momentsOf(sites_, a, b);
    return spread > 0.0 && std::abs(mean) > criticalT_ * std::sqrt(spread / (n * (n - 1.0)));
  }

  /// Whether a test is significant for any pair except the first.
  template <typename Test>
  bool isSignificantForAnotherPair(const Test& test) const {
    for (std::size_t a = 0; a < conditions_; ++a) {
      for (std::size_t b = std::max<std::size_t>(a + 1, 2); b < conditions_; ++b) {
        if (test(a, b)) return true;
      }
    }
    return false;
  }

 private:
  struct DifferenceMoments {
    double n = 0.0;
    double mean = 0.0;    ///< of the participants' mean differences [points]
    double spread = 0.0;  ///< Σ (D − mean)²; exactly 0 if all differences are equal
  };

  DifferenceMoments momentsOf(std::span<const SiteSums> sites, std::size_t a, std::size_t b) const {
    double n = 0.0;
    double sum = 0.0;
    double squares = 0.0;
    for (const auto& site : sites) {
      n += static_cast<double>(site.size());
      for (const auto& sums : site) {
        const double d = sums[a] - sums[b];
        sum += d;
        squares += d * d;
      }
    }
    const double spread = n * squares - sum * sum;  // whole numbers: exact
    return {n, sum / (n * answers_), spread / (n * answers_ * answers_)};
  }

  std::size_t conditions_;
  int answers_;
  double level_;        ///< α of one comparison
  double pooledLevel_;  ///< level of a pooled interval: 1 − α of the family
  double deviation_;
  double criticalT_;  ///< critical |t| of the test of all participants, sites ignored
  std::vector<SiteSums> sites_;
};

std::optional<double> medianOf(std::vector<double> values, std::uint64_t studies) {
  if (2 * values.size() < studies || values.empty()) return std::nullopt;
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  return *middle;
}

}  // namespace

double SitePlan::intraclassCorrelation() const {
  return deviation * deviation / (1.0 + deviation * deviation);
}

double SitePlan::designEffect(std::uint64_t participants) const {
  const double participantsPerSite = static_cast<double>(participants) / static_cast<double>(sites);
  return 1.0 + (participantsPerSite - 1.0) * intraclassCorrelation();
}

void SitePlan::check() const {
  if (sites < 2 || !std::isfinite(deviation) || deviation < 0.0) {
    throw std::invalid_argument(
        "a plan has two sites, and a deviation between them that is not negative");
  }
}

double pooledSitesPower(double dz, std::uint64_t participants, const SitePlan& plan, double alpha) {
  checkSites(plan, participants);
  const auto k = static_cast<double>(plan.sites);
  const double ofParticipants = k / static_cast<double>(participants);
  const double error = std::sqrt((plan.deviation * plan.deviation + ofParticipants) / k);
  return twoSidedTPower(dz / error, k - 1.0, alpha);
}

std::optional<std::uint64_t> participantsForPower(
    double dz, const SitePlan& plan, double alpha, double power) {
  plan.check();
  return fewestParticipants(plan.fewestParticipants(), alpha, power, [&](std::uint64_t n) {
    return dz != 0.0 && pooledSitesPower(dz, n, plan, alpha) >= power;
  });
}

SimulatedSitePower simulateSitePower(const PowerSimulation& simulation, const SitePlan& plan) {
  simulation.check();
  checkSites(plan, simulation.participants);
  LikertCohort cohort(simulation.model, simulation.seed);
  SimulatedSiteStudy study(simulation, plan);
  std::array<std::uint64_t, 4> found{};
  std::vector<double> halfWidths;
  for (std::uint64_t i = 0; i < simulation.studies; ++i) {
    study.draw(cohort);
    const auto paired = [&](std::size_t a, std::size_t b) { return study.pairedT(a, b); };
    const auto pooled = [&](std::size_t a, std::size_t b) {
      return study.isDetected(study.pooledDifference(a, b));
    };
    const auto first = study.pooledDifference(0, 1);
    if (first) halfWidths.push_back(0.5 * (first->interval.high - first->interval.low));
    const bool isPooled = study.isDetected(first);
    const bool isPaired = paired(0, 1);
    found[0] += isPooled ? 1 : 0;
    found[1] += isPooled || study.isSignificantForAnotherPair(pooled) ? 1 : 0;
    found[2] += isPaired ? 1 : 0;
    found[3] += isPaired || study.isSignificantForAnotherPair(paired) ? 1 : 0;
  }
  const auto rate = [&](std::size_t which) {
    return DetectionRate::of(found[which], simulation.studies);
  };
  return {
      .pooled = rate(0),
      .anyPooled = rate(1),
      .pairedT = rate(2),
      .anyPairedT = rate(3),
      .medianHalfWidth = medianOf(std::move(halfWidths), simulation.studies)};
}

}  // namespace analysis
