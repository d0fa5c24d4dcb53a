#pragma once

namespace analysis {

/// Student's t with ν degrees of freedom, which need not be a whole number.
///
/// Both tails together are
///
///     P(|T| ≥ |t|) = I_x(ν/2, 1/2),   x = ν / (ν + t²),
///
/// with I the regularised incomplete beta function.
class StudentDistribution {
 public:
  /// @param degreesOfFreedom  finite and not less than one: Welch's are never fewer.
  /// @throws std::invalid_argument  for others.
  explicit StudentDistribution(double degreesOfFreedom);

  /// P(|T| ≥ |t|). Zero, or less exact, below 1e-300: ask log10TwoSidedP() then.
  double twoSidedP(double t) const;

  /// log₁₀ P(|T| ≥ |t|), of full precision near one and far beyond what a double can hold.
  double log10TwoSidedP(double t) const;

  /// The t that |T| exceeds with a probability of @p p in (0, 1].
  /// @throws std::invalid_argument  for others.
  double twoSidedQuantile(double p) const;

 private:
  double degreesOfFreedom_;
};

}  // namespace analysis
