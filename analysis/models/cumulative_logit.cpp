#include "analysis/models/cumulative_logit.h"

#include <cmath>

namespace analysis {
namespace {

/// ln F(x).
double logLogistic(double x) {
  return x > 0.0 ? -std::log1p(std::exp(-x)) : x - std::log1p(std::exp(x));
}

/// F(x) without loss for a very negative x.
double logistic(double x) {
  if (x > 0.0) return 1.0 / (1.0 + std::exp(-x));
  const double power = std::exp(x);
  return power / (1.0 + power);
}

}  // namespace

CumulativeLogit::CumulativeLogit(double above, double below) {
  const double overA = logistic(-above);  // 1 − F(a)
  const double underB = logistic(below);  // F(b)
  densityAbove = overA * logistic(above);
  densityBelow = underB * logistic(-below);
  densitySlopeAbove = densityAbove * (2.0 * overA - 1.0);
  densitySlopeBelow = densityBelow * (1.0 - 2.0 * underB);
  slope = underB - overA;
  weight = densityAbove + densityBelow;

  const bool isBetween = std::isfinite(above) && std::isfinite(below);
  const double gap = isBetween ? std::expm1(above - below) : HUGE_VAL;  // e^{a−b} − 1
  slopeAbove = overA + 1.0 / gap;
  slopeBelow = -underB - 1.0 / gap;
  logProbability = (std::isfinite(above) ? logLogistic(above) : 0.0) +
                   (std::isfinite(below) ? logLogistic(-below) : 0.0) +
                   (isBetween ? std::log(-std::expm1(below - above)) : 0.0);
}

}  // namespace analysis
