#include "haptics/reaming/material/monotone_slopes.h"

#include <cmath>

namespace haptics::reaming {
namespace {

/// The three-point slope at an end, limited so that it neither turns nor overshoots.
double endSlope(double h0, double h1, double rise0, double rise1) {
  const double slope = ((2.0 * h0 + h1) * rise0 - h0 * rise1) / (h0 + h1);
  if (slope * rise0 <= 0.0) return 0.0;
  if (rise0 * rise1 <= 0.0 && std::abs(slope) > 3.0 * std::abs(rise0)) return 3.0 * rise0;
  return slope;
}

}  // namespace

std::vector<double> monotoneSlopes(
    const std::vector<double>& positions, const std::vector<double>& values) {
  const std::size_t n = positions.size();
  std::vector<double> h(n - 1);
  std::vector<double> rise(n - 1);
  for (std::size_t i = 0; i + 1 < n; ++i) {
    h[i] = positions[i + 1] - positions[i];
    rise[i] = (values[i + 1] - values[i]) / h[i];
  }
  if (n == 2) return {rise[0], rise[0]};

  std::vector<double> slopes(n, 0.0);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    if (rise[i - 1] * rise[i] <= 0.0) continue;
    const double w1 = 2.0 * h[i] + h[i - 1];
    const double w2 = h[i] + 2.0 * h[i - 1];
    slopes[i] = (w1 + w2) / (w1 / rise[i - 1] + w2 / rise[i]);
  }
  slopes[0] = endSlope(h[0], h[1], rise[0], rise[1]);
  slopes[n - 1] = endSlope(h[n - 2], h[n - 3], rise[n - 2], rise[n - 3]);
  return slopes;
}

}  // namespace haptics::reaming
