#pragma once

#include <cstdint>
#include <random>
#include <vector>

namespace analysis {

/// A model of how participants answer, for planning a study; it describes no data.
///
/// Every answer comes from a latent number,
///
///     x = m_c + P + M_c + R,
///
/// the level of the condition, the participant's leniency, the participant's liking of this
/// condition, and a residual. P, M and R are normal, with variances that add up to one. The
/// answer is the point of the scale that x falls on: the thresholds lie 0.8 apart around zero, so
/// that on five points about 12, 23, 31, 23 and 12 % choose each where m_c = 0.
struct LikertModel {
  double participantShare = 0.3;  ///< of the variance
  double participantByConditionShare = 0.2;
  double residualShare = 0.5;
  int points = 5;
  int conditions = 3;
  int answers = 6;  ///< of each participant to each condition
  double dz = 1.0;  ///< effect of the first condition against every other [standard deviations]

  /// The difference of levels for which two participants' latent means differ by d_z standard
  /// deviations of that difference: d_z √(2 (σ_M² + σ_R² / answers)).
  double levelOfFirst() const;

  /// @throws std::invalid_argument  for shares that are negative or do not add up to one, fewer
  ///     than two points or conditions, no answers, or an effect that is NaN.
  void check() const;
};

/// The answers of one participant: [condition][answer], from 1 to the number of points.
using LikertAnswers = std::vector<std::vector<int>>;

/// Draws participants one after the other; the same seed gives the same answers on every computer,
/// which the normal distribution of the standard library does not promise.
class LikertCohort {
 public:
  /// @throws std::invalid_argument  as LikertModel::check().
  LikertCohort(const LikertModel& model, std::uint64_t seed);

  LikertAnswers next();

 private:
  double normal();
  int pointAt(double x) const;

  LikertModel model_;
  double levelOfFirst_;
  std::mt19937_64 random_;
  double spare_ = 0.0;  ///< Box & Muller's method gives two numbers at a time
  bool hasSpare_ = false;
};

}  // namespace analysis
