#pragma once

#include <cstdint>
#include <random>
#include <span>
#include <vector>

namespace analysis {

/// A model of how participants answer, used to simulate data when a study is planned. It is not
/// fitted to data.
///
/// Every answer comes from a latent number,
///
///     x = m_c + P + M_c + R,
///
/// the mean of the condition, the participant's leniency, the participant's liking of this
/// condition, and a residual. P, M and R are normal, with variances that add up to one. The answer
/// is the point of the scale that x falls on: the thresholds lie 0.8 apart around zero, so that for
/// m_c = 0, about 12, 23, 31, 23 and 12 % of answers fall on each of five points.
struct LikertModel {
  double participantShare = 0.3;  ///< share of P in the variance
  double participantByConditionShare = 0.2;
  double residualShare = 0.5;
  int points = 5;
  int conditions = 3;
  int answers = 6;  ///< of each participant to each condition
  double dz = 1.0;  ///< effect of the first condition against each other one [standard deviations
                    ///< of the difference]

  /// m_c of the first condition (that of the others is 0), such that participants' mean differences
  /// have an effect size of d_z: d_z √(2 (σ_M² + σ_R² / answers)).
  double latentMeanOfFirst() const;

  /// The standard deviation of the participants' latent mean differences of two conditions:
  /// √(2 (σ_M² + σ_R² / answers)).
  double sdOfDifferences() const;

  /// @throws std::invalid_argument  for shares that are negative or do not add up to one, fewer
  ///     than two points or conditions, no answers, or an effect that is not finite.
  void check() const;
};

/// The answers of one participant: [condition][answer], from 1 to the number of points.
using LikertAnswers = std::vector<std::vector<int>>;

/// Draws participants one after the other; the same seed gives the same answers on every computer,
/// which the normal distribution of the standard library does not guarantee.
class LikertCohort {
 public:
  /// @throws std::invalid_argument  as LikertModel::check().
  LikertCohort(const LikertModel& model, std::uint64_t seed);

  /// The next participant.
  /// @param shifts  added to m_c of each condition at the participant's site; empty: none
  LikertAnswers next(std::span<const double> shifts = {});

  /// Draws the shifts of all conditions at the next site. The difference of two conditions then
  /// has, between sites, a standard deviation of @p deviation times that between participants.
  std::vector<double> drawSiteShifts(double deviation);

 private:
  double normal();
  int pointAt(double x) const;

  LikertModel model_;
  double latentMeanOfFirst_;
  std::mt19937_64 random_;
  double cachedNormal_ = 0.0;  ///< the second number of the pair that Box & Muller's method gives
  bool hasCachedNormal_ = false;
};

/// The share of simulated studies in which a test was significant.
struct DetectionRate {
  double rate = 0.0;
  double standardError = 0.0;  ///< of the simulation: √(rate (1 − rate) / studies)

  static DetectionRate of(std::uint64_t found, std::uint64_t studies);
};

/// The parameters of a power simulation.
struct PowerSimulation {
  LikertModel model;
  std::uint64_t participants = 12;
  double alpha = 0.05;
  double alphaPerTest = 0.05 / 3.0;  ///< of a pair
  std::uint64_t studies = 2000;
  std::uint64_t seed = 1;

  /// @throws std::invalid_argument  as LikertModel::check(); for fewer than two participants, no
  ///     studies, and an alpha that is not between 0 and 1.
  void check() const;
};

/// The share of simulated studies that each test finds significant; all tests use the same studies.
/// "First pair": the first condition against the second, where the effect is. "Any pair": at least
/// one of all pairs of conditions, which is the familywise error if there is no effect.
struct SimulatedPower {
  DetectionRate pairedT;     ///< first pair, means of participants, at the α of a pair
  DetectionRate signFlip;    ///< first pair, by flipping the signs of the differences
  DetectionRate signedRank;  ///< first pair, by Wilcoxon's signed rank test, exact with ties
  DetectionRate friedman;    ///< overall test of all conditions, means of participants, χ², at α
  DetectionRate anyPairedT;  ///< as pairedT, for any pair
  DetectionRate pooledWelch;     ///< first pair, all single answers treated as independent
  DetectionRate anyPooledWelch;  ///< as pooledWelch, for any pair
};

/// Simulates studies. The signed rank test drops differences of zero. Its p and that of sign flips
/// are exact where they are soon counted, for up to 50 ranks, and otherwise from the normal
/// approximation with correction for ties and continuity. A test that is not defined (all
/// differences equal) counts as not significant. Runs in one thread with one stream of random
/// numbers: the same arguments give the same result.
///
/// @throws std::invalid_argument  as PowerSimulation::check().
SimulatedPower simulatePower(const PowerSimulation& simulation);

}  // namespace analysis
