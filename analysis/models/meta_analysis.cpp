#include "analysis/models/meta_analysis.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

#include "analysis/numerics/distributions.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

/// For each value the sum of all others, computed without subtraction, which would lose digits.
std::vector<double> sumsOfOthers(const std::vector<double>& values) {
  std::vector<double> sums(values.size(), 0.0);
  double before = 0.0;
  double after = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::size_t j = values.size() - 1 - i;
    sums[i] += before;
    sums[j] += after;
    before += values[i];
    after += values[j];
  }
  return sums;
}

/// The sites with their weights for one τ².
class WeightedSites {
 public:
  WeightedSites(std::span<const EstimateWithError> sites, double tauSquared) : sites_(sites) {
    double sum = 0.0;
    for (const auto& site : sites) {
      const double weight = 1.0 / (site.standardError * site.standardError + tauSquared);
      weights_.push_back(weight);
      weight_ += weight;
      logVariance_ -= std::log(weight);
      sum += weight * site.estimate;
    }
    mean_ = sum / weight_;
  }

  double mean() const noexcept { return mean_; }
  double weight() const noexcept { return weight_; }
  double df() const noexcept { return static_cast<double>(sites_.size()) - 1.0; }
  /// The trace of P = W − w wᵀ / Σ w, and of its square: sums without negative terms, which stay
  /// accurate if one weight is far above all others.
  double trace() const {
    const auto others = sumsOfOthers(weights_);
    double sum = 0.0;
    for (std::size_t i = 0; i < weights_.size(); ++i) sum += weights_[i] * (others[i] / weight_);
    return sum;
  }
  double traceOfSquare() const {
    const auto others = sumsOfOthers(weights_);
    std::vector<double> shares;  // w² / Σ w
    for (const double weight : weights_) shares.push_back(weight * (weight / weight_));
    const auto otherShares = sumsOfOthers(shares);
    double sum = 0.0;
    for (std::size_t i = 0; i < weights_.size(); ++i) {
      const double diagonal = weights_[i] * (others[i] / weight_);
      sum += diagonal * diagonal + shares[i] * otherShares[i];
    }
    return sum;
  }
  /// Σ wᵖ (yᵢ − μ̂)².
  double deviation(int power) const {
    double sum = 0.0;
    for (std::size_t i = 0; i < sites_.size(); ++i) {
      const double from = sites_[i].estimate - mean_;
      sum += (power == 1 ? weights_[i] : weights_[i] * weights_[i]) * from * from;
    }
    return sum;
  }
  /// −2 log restricted likelihood, up to a constant.
  double restrictedDeviance() const { return logVariance_ + std::log(weight_) + deviation(1); }
  /// The variance of a typical site (Higgins & Thompson 2002). @pre τ² = 0
  double typicalVariance() const { return df() / trace(); }

 private:
  std::span<const EstimateWithError> sites_;
  std::vector<double> weights_;
  double weight_ = 0.0;
  double logVariance_ = 0.0;
  double mean_ = 0.0;
};

double derSimonianLaird(const WeightedSites& equal) {
  return std::max(0.0, (equal.deviation(1) - equal.df()) / equal.trace());
}

constexpr double kFullPrecision = 4.0 * std::numeric_limits<double>::epsilon();

/// τ² of REML by Fisher scoring. The likelihood of few sites may have a second maximum at 0; the
/// larger one of the two maxima is returned.
double remlFrom(std::span<const EstimateWithError> sites, double start, double precision) {
  constexpr int kMostScorings = 10'000;
  double smallest = std::numeric_limits<double>::infinity();
  for (const auto& site : sites) {
    smallest = std::min(smallest, site.standardError * site.standardError);
  }
  double tauSquared = start;
  for (int step = 0; step < kMostScorings; ++step) {
    const WeightedSites weighted(sites, tauSquared);
    const double change = (weighted.deviation(2) - weighted.trace()) / weighted.traceOfSquare();
    const double next = std::max(0.0, tauSquared + change);
    // The change is a difference of sums in 1 / (variance + τ²). Relative to a small τ² its last
    // digits are rounding noise, and the loop would never end.
    const bool hasConverged = std::abs(next - tauSquared) <= precision * (next + smallest);
    tauSquared = next;
    if (hasConverged) break;
  }
  const bool isZeroBetter = WeightedSites(sites, 0.0).restrictedDeviance() <=
                            WeightedSites(sites, tauSquared).restrictedDeviance();
  return isZeroBetter ? 0.0 : tauSquared;
}

/// The mean square of the estimates around their mean: τ² if the standard errors were zero.
double spreadOf(std::span<const EstimateWithError> sites) {
  double mean = 0.0;
  double squares = 0.0;
  for (const auto& site : sites) mean += site.estimate / static_cast<double>(sites.size());
  for (const auto& site : sites) squares += (site.estimate - mean) * (site.estimate - mean);
  return squares / static_cast<double>(sites.size() - 1);
}

class Pooling {
 public:
  Pooling(std::span<const EstimateWithError> sites, double level, double precision = kFullPrecision)
      : sites_(sites), level_(level), precision_(precision), commonEffect_(checked(sites), 0.0) {}

  PooledEstimate pooledWith(double tauSquared, double varianceBetween) const {
    const WeightedSites weighted(sites_, tauSquared);
    const double error = std::sqrt(1.0 / weighted.weight());
    return estimate(weighted.mean(), error, std::nullopt, tauSquared, varianceBetween);
  }

  PooledEstimate knappHartung(double tauSquared) const {
    const WeightedSites weighted(sites_, tauSquared);
    const double q = std::max(1.0, weighted.deviation(1) / weighted.df());
    const double error = std::sqrt(q / weighted.weight());
    return estimate(weighted.mean(), error, weighted.df(), tauSquared, tauSquared);
  }

  double reml() const {
    return remlFrom(
        sites_, std::max(derSimonianLaird(commonEffect_), spreadOf(sites_)), precision_);
  }

  MetaAnalysis all() const {
    const double simple = derSimonianLaird(commonEffect_);
    const double largest = reml();
    MetaAnalysis result{
        .sites = sites_.size(),
        .q = commonEffect_.deviation(1),
        .common = pooledWith(0.0, simple),
        .derSimonianLaird = pooledWith(simple, simple),
        .reml = pooledWith(largest, largest),
        .knappHartung = knappHartung(largest)};
    result.heterogeneityP = chiSquaredP(result.q, commonEffect_.df());
    return result;
  }

 private:
  static std::span<const EstimateWithError> checked(std::span<const EstimateWithError> sites) {
    if (sites.size() < 2) throw std::invalid_argument("two sites are needed to pool them");
    for (const auto& site : sites) {
      const bool isSound = std::isfinite(site.estimate) && std::isfinite(site.standardError) &&
                           site.standardError > 0.0;
      if (!isSound) throw std::invalid_argument("an estimate needs a positive standard error");
    }
    return sites;
  }

  PooledEstimate estimate(
      double mean,
      double error,
      std::optional<double> df,
      double tauSquared,
      double varianceBetween) const {
    const double reach = error * (df ? StudentDistribution(*df).twoSidedQuantile(1.0 - level_)
                                     : normalTwoSidedQuantile(level_));
    const double statistic = mean / error;
    return {
        .estimate = mean,
        .standardError = error,
        .interval = {.low = mean - reach, .high = mean + reach},
        .statistic = statistic,
        .df = df,
        .p = df ? StudentDistribution(*df).twoSidedP(statistic) : normalTwoSidedP(statistic),
        .tauSquared = tauSquared,
        .iSquared = varianceBetween / (varianceBetween + commonEffect_.typicalVariance())};
  }

  std::span<const EstimateWithError> sites_;
  double level_;
  double precision_;
  WeightedSites commonEffect_;  ///< τ² = 0
};

}  // namespace

MetaAnalysis pooled(std::span<const EstimateWithError> sites, double level) {
  return Pooling(sites, level).all();
}

PooledEstimate pooledToFourDigits(std::span<const EstimateWithError> sites, double level) {
  constexpr double kQuickPrecision = 1e-6;  // relative, of τ²: the results keep four digits
  const Pooling pooling(sites, level, kQuickPrecision);
  return pooling.knappHartung(pooling.reml());
}

std::vector<PooledEstimate> leaveOneOut(std::span<const EstimateWithError> sites, double level) {
  std::vector<PooledEstimate> results;
  if (sites.size() < 3) return results;
  for (std::size_t i = 0; i < sites.size(); ++i) {
    std::vector<EstimateWithError> others(sites.begin(), sites.end());
    others.erase(others.begin() + static_cast<std::ptrdiff_t>(i));
    const Pooling pooling(others, level);
    results.push_back(pooling.knappHartung(pooling.reml()));
  }
  return results;
}

}  // namespace analysis
