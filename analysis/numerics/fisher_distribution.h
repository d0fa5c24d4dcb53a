#pragma once

namespace analysis {

/// Fisher's F with ν₁ and ν₂ degrees of freedom, which need not be whole numbers.
///
///     P(F ≥ f) = I_x(ν₂/2, ν₁/2),   x = ν₂ / (ν₂ + ν₁ f)
///
/// with I the regularised incomplete beta function.
class FisherDistribution {
 public:
  /// @throws std::invalid_argument  for degrees of freedom that are not finite and above 0.
  FisherDistribution(double degreesOfFreedom1, double degreesOfFreedom2);

  /// P(F ≥ f) for f ≥ 0. Below 1e-300 it loses digits, and becomes 0: use log10UpperP() there.
  /// @throws std::invalid_argument  for an f that is infinite, negative or no number.
  double upperP(double f) const;

  /// log₁₀ P(F ≥ f), of full precision both near p = 1 and where p is too small for a double.
  /// @throws std::invalid_argument  as above.
  double log10UpperP(double f) const;

  /// The f that F exceeds with a probability of @p p in (0, 1); infinity beyond a double.
  /// @throws std::invalid_argument  for others.
  double upperQuantile(double p) const;

 private:
  double degreesOfFreedom1_;
  double degreesOfFreedom2_;
};

}  // namespace analysis
