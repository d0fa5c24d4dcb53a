#pragma once

namespace analysis {

/// ln π of one answer between two thresholds a and b of the logistic law, and its derivatives.
///
/// With η the linear predictor, a = θ_y − η above and b = θ_{y−1} − η below the answer,
///
///     π = F(a) − F(b) = F(a) (1 − F(b)) (1 − e^{b−a}),   F(x) = 1 / (1 + e^{−x}),
///
/// where the last factor does not depend on η; nothing cancels however small π is.
struct CumulativeLogit {
  /// @param above  a, +infinity for the highest level.
  /// @param below  b < a, −infinity for the lowest level.
  CumulativeLogit(double above, double below);

  double logProbability;
  double slope;              ///< d ln π / dη
  double weight;             ///< −d² ln π / dη² = f(a) + f(b) > 0, with f = F (1 − F)
  double slopeAbove;         ///< d ln π / da
  double slopeBelow;         ///< d ln π / db
  double densityAbove;       ///< f(a) = d² ln π / (da dη)
  double densityBelow;       ///< f(b) = d² ln π / (db dη)
  double densitySlopeAbove;  ///< f'(a); d weight / dη = −f'(a) − f'(b)
  double densitySlopeBelow;  ///< f'(b)
};

}  // namespace analysis
