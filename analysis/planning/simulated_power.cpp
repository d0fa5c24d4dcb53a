#include "analysis/planning/simulated_power.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <stdexcept>
#include <vector>

#include "analysis/numerics/distributions.h"
#include "analysis/numerics/tail_probabilities.h"

namespace analysis {
namespace {

constexpr double kThresholdDistance = 0.8;

/// A uniform number in (0, 1], from the upper 53 bits.
double uniform(std::mt19937_64& random) {
  return (static_cast<double>(random() >> 11U) + 1.0) * 0x1p-53;
}

}  // namespace

double LikertModel::latentMeanOfFirst() const {
  return dz * sdOfDifferences();
}

double LikertModel::sdOfDifferences() const {
  return std::sqrt(2.0 * (participantByConditionShare + residualShare / answers));
}

void LikertModel::check() const {
  const double least = std::min({participantShare, participantByConditionShare, residualShare});
  const double sum = participantShare + participantByConditionShare + residualShare;
  // Shares are written as decimals; their sum may differ from one by rounding.
  if (!(least >= 0.0 && std::abs(sum - 1.0) < 1e-9)) {
    throw std::invalid_argument("shares of the variance are not negative and add up to one");
  }
  if (points < 2 || conditions < 2 || answers < 1 || !std::isfinite(dz)) {
    throw std::invalid_argument("a model has two points, two conditions, an answer and an effect");
  }
}

LikertCohort::LikertCohort(const LikertModel& model, std::uint64_t seed)
    : model_((model.check(), model)),
      latentMeanOfFirst_(model.latentMeanOfFirst()),
      random_(seed) {}

double LikertCohort::normal() {
  hasCachedNormal_ = !hasCachedNormal_;
  if (!hasCachedNormal_) return cachedNormal_;
  const double radius = std::sqrt(-2.0 * std::log(uniform(random_)));
  const double angle = 2.0 * std::numbers::pi * uniform(random_);
  cachedNormal_ = radius * std::sin(angle);
  return radius * std::cos(angle);
}

int LikertCohort::pointAt(double x) const {
  const double middle = 0.5 * (model_.points + 1);
  const double point = std::floor(x / kThresholdDistance + middle + 0.5);
  return static_cast<int>(std::clamp(point, 1.0, static_cast<double>(model_.points)));
}

std::vector<double> LikertCohort::drawSiteShifts(double deviation) {
  // The difference of two independent shifts has √2 times the deviation of each.
  const double siteDeviation = deviation * model_.sdOfDifferences() / std::numbers::sqrt2;
  std::vector<double> shifts;
  for (int c = 0; c < model_.conditions; ++c) shifts.push_back(siteDeviation * normal());
  return shifts;
}

LikertAnswers LikertCohort::next(std::span<const double> shifts) {
  const double personEffect = std::sqrt(model_.participantShare) * normal();
  LikertAnswers answers;
  for (int c = 0; c < model_.conditions; ++c) {
    const double shift = shifts.empty() ? 0.0 : shifts[static_cast<std::size_t>(c)];
    const double level = (c == 0 ? latentMeanOfFirst_ : 0.0) + personEffect + shift +
                         std::sqrt(model_.participantByConditionShare) * normal();
    auto& conditionAnswers = answers.emplace_back();
    for (int i = 0; i < model_.answers; ++i) {
      conditionAnswers.push_back(pointAt(level + std::sqrt(model_.residualShare) * normal()));
    }
  }
  return answers;
}

namespace {

constexpr std::size_t kMostExactSteps = 50U * 50U * 51U;  // of counting the signs of 50 ranks
using Sums = std::vector<int>;  ///< of one participant's answers, by condition

/// Twice the midranks, which are whole numbers.
std::vector<int> doubledRanks(const std::vector<int>& values) {
  auto sorted = values;
  std::ranges::sort(sorted);
  std::vector<int> ranks;
  for (const int value : values) {
    const auto [first, last] = std::equal_range(sorted.begin(), sorted.end(), value);
    const auto below = first - sorted.begin();
    ranks.push_back(static_cast<int>(2 * below + (last - first) + 1));
  }
  return ranks;
}

/// P(sum of the positive @p sizes ≤ @p least), if all 2ⁿ assignments of signs are equally likely.
double lowerTail(const std::vector<int>& sizes, int least) {
  std::vector<double> ways(static_cast<std::size_t>(least) + 1, 0.0);
  ways[0] = 1.0;
  for (const int size : sizes) {
    for (int sum = least; sum >= size; --sum) {
      ways[static_cast<std::size_t>(sum)] += ways[static_cast<std::size_t>(sum - size)];
    }
  }
  const double all = std::accumulate(ways.begin(), ways.end(), 0.0);
  return std::ldexp(all, -static_cast<int>(sizes.size()));
}

/// The two-sided p of the sum of @p sizes with the signs of @p differences, none of which is 0.
/// @param step  between two sums of the positive ones
double flippedP(const std::vector<int>& differences, const std::vector<int>& sizes, double step) {
  if (sizes.empty()) return 1.0;
  int positive = 0;
  int total = 0;
  double variance = 0.0;
  for (std::size_t i = 0; i < sizes.size(); ++i) {
    positive += differences[i] > 0 ? sizes[i] : 0;
    total += sizes[i];
    variance += 0.25 * sizes[i] * sizes[i];
  }
  const int least = std::min(positive, total - positive);
  if (sizes.size() * static_cast<std::size_t>(total) <= kMostExactSteps) {
    return std::min(1.0, 2.0 * lowerTail(sizes, least));
  }
  const double z = std::max(0.0, 0.5 * (total - step) - least) / std::sqrt(variance);
  return normalTwoSidedP(z);
}

std::vector<int> magnitudesOf(const std::vector<int>& differences) {
  std::vector<int> sizes;
  for (const int d : differences) sizes.push_back(std::abs(d));
  return sizes;
}

/// One simulated study and the critical values of its tests. For speed, the tests use integer sums
/// and critical values that are computed once: a power simulation runs thousands of studies.
class SimulatedStudy {
 public:
  explicit SimulatedStudy(const PowerSimulation& s)
      : conditions_(static_cast<std::size_t>(s.model.conditions)),
        answers_(s.model.answers),
        level_(s.alphaPerTest),
        criticalT_(
            StudentDistribution(static_cast<double>(s.participants - 1)).twoSidedQuantile(level_)),
        criticalChiSquared_(
            chiSquaredUpperQuantile(s.alpha, static_cast<double>(conditions_ - 1))) {}

  void draw(LikertCohort& cohort, std::uint64_t participants) {
    sums_.clear();
    totals_.assign(conditions_, 0.0);
    squares_.assign(conditions_, 0.0);
    for (std::uint64_t i = 0; i < participants; ++i) {
      auto& sums = sums_.emplace_back();
      const auto answers = cohort.next();
      for (std::size_t c = 0; c < conditions_; ++c) {
        sums.push_back(std::accumulate(answers[c].begin(), answers[c].end(), 0));
        totals_[c] += sums[c];
        for (const int answer : answers[c]) squares_[c] += answer * answer;
      }
    }
  }

  bool pairedT(std::size_t a, std::size_t b) const {
    const auto n = static_cast<double>(sums_.size());
    double sum = 0.0;
    double squares = 0.0;
    for (const int d : differences(a, b)) {
      sum += d;
      squares += static_cast<double>(d) * d;
    }
    const double spread = n * squares - sum * sum;  // whole numbers: exact
    return spread > 0.0 && std::abs(sum) * std::sqrt(n - 1.0) > criticalT_ * std::sqrt(spread);
  }

  bool signFlip(std::size_t a, std::size_t b) const {
    const auto different = differencesWithoutZeros(a, b);
    return flippedP(different, magnitudesOf(different), 1.0) <= level_;
  }

  bool signedRank(std::size_t a, std::size_t b) const {
    const auto different = differencesWithoutZeros(a, b);
    return flippedP(different, doubledRanks(magnitudesOf(different)), 2.0) <= level_;
  }

  bool pooledWelch(std::size_t a, std::size_t b) {
    const double n = static_cast<double>(sums_.size()) * answers_;
    const double va = (n * squares_[a] - totals_[a] * totals_[a]) / (n * n * (n - 1.0));
    const double vb = (n * squares_[b] - totals_[b] * totals_[b]) / (n * n * (n - 1.0));
    if (!(va + vb > 0.0)) return false;
    const double df = (n - 1.0) * (va + vb) * (va + vb) / (va * va + vb * vb);
    const double t = std::abs(totals_[a] - totals_[b]) / n / std::sqrt(va + vb);
    // The critical t falls with the degrees of freedom, so most cases are decided without computing
    // p.
    if (t < quantileAt(std::ceil(df))) return false;
    return t > quantileAt(std::floor(df)) || StudentDistribution(df).twoSidedP(t) <= level_;
  }

  bool friedman() const {
    std::vector<double> ranks(conditions_, 0.0);
    const auto n = static_cast<double>(sums_.size());
    const auto k = static_cast<double>(conditions_);
    double ties = 0.0;
    for (const auto& sums : sums_) {
      const auto doubled = doubledRanks(sums);
      for (std::size_t c = 0; c < conditions_; ++c) {
        ranks[c] += 0.5 * doubled[c];
        const auto same = static_cast<double>(std::ranges::count(sums, sums[c]));
        ties += same * same - 1.0;  // t³ − t of a run of t ties, shared among its members
      }
    }
    double spread = 0.0;
    for (const double rank : ranks) spread += std::pow(rank - 0.5 * n * (k + 1.0), 2);
    const double scale = n * k * (k + 1.0) - ties / (k - 1.0);
    return scale > 0.0 && 12.0 * spread >= criticalChiSquared_ * scale;
  }

  template <typename Test>
  bool isSignificantForAnyPair(const Test& test) const {
    for (std::size_t a = 0; a < conditions_; ++a) {
      for (std::size_t b = a + 1; b < conditions_; ++b) {
        if (test(a, b)) return true;
      }
    }
    return false;
  }

 private:
  std::vector<int> differences(std::size_t a, std::size_t b) const {
    std::vector<int> found;
    for (const auto& sums : sums_) found.push_back(sums[a] - sums[b]);
    return found;
  }

  std::vector<int> differencesWithoutZeros(std::size_t a, std::size_t b) const {
    auto found = differences(a, b);
    std::erase(found, 0);
    return found;
  }

  double quantileAt(double df) {
    const auto found = quantiles_.find(df);
    if (found != quantiles_.end()) return found->second;
    return quantiles_[df] = StudentDistribution(std::max(df, 1.0)).twoSidedQuantile(level_);
  }

  std::size_t conditions_;
  int answers_;
  double level_;  ///< α of one comparison
  double criticalT_;
  double criticalChiSquared_;
  std::map<double, double> quantiles_;  ///< of Student's t, by degrees of freedom
  std::vector<Sums> sums_;              ///< [participant][condition]
  std::vector<double> totals_;          ///< Σ x over all answers to a condition
  std::vector<double> squares_;         ///< Σ x²
};

}  // namespace

DetectionRate DetectionRate::of(std::uint64_t found, std::uint64_t studies) {
  const double rate = static_cast<double>(found) / static_cast<double>(studies);
  return {rate, std::sqrt(rate * (1.0 - rate) / static_cast<double>(studies))};
}

void PowerSimulation::check() const {
  const auto isLevel = [](double level) { return level > 0.0 && level < 1.0; };
  const bool isSound = participants >= 2 && studies > 0 && isLevel(alpha) && isLevel(alphaPerTest);
  if (!isSound) {
    throw std::invalid_argument(
        "a simulation needs two participants, a study, and an alpha between 0 and 1");
  }
  model.check();
}

SimulatedPower simulatePower(const PowerSimulation& simulation) {
  simulation.check();
  LikertCohort cohort(simulation.model, simulation.seed);
  SimulatedStudy study(simulation);
  std::array<std::uint64_t, 7> found{};
  for (std::uint64_t i = 0; i < simulation.studies; ++i) {
    study.draw(cohort, simulation.participants);
    const auto paired = [&](std::size_t a, std::size_t b) { return study.pairedT(a, b); };
    const auto welch = [&](std::size_t a, std::size_t b) { return study.pooledWelch(a, b); };
    found[0] += paired(0, 1) ? 1 : 0;
    found[1] += study.signedRank(0, 1) ? 1 : 0;
    found[2] += study.friedman() ? 1 : 0;
    found[3] += study.isSignificantForAnyPair(paired) ? 1 : 0;
    found[4] += welch(0, 1) ? 1 : 0;
    found[5] += study.isSignificantForAnyPair(welch) ? 1 : 0;
    found[6] += study.signFlip(0, 1) ? 1 : 0;
  }
  const auto rate = [&](std::size_t which) {
    return DetectionRate::of(found[which], simulation.studies);
  };
  return {
      .pairedT = rate(0),
      .signFlip = rate(6),
      .signedRank = rate(1),
      .friedman = rate(2),
      .anyPairedT = rate(3),
      .pooledWelch = rate(4),
      .anyPooledWelch = rate(5)};
}

}  // namespace analysis
