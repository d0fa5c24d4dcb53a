#include "haptics/reaming/material/spline.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace haptics::reaming {

namespace {

/// The three-point slope at an end, limited so that the curve stays monotone and does not
/// overshoot.
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

namespace {

/// Akima's slopes, modified so that flat data stay flat: the weight of a side is |δ₂ − δ₁| + |δ₂ +
/// δ₁|/2 of the other side.
std::vector<double> makimaSlopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  if (n == 2) return monotoneSlopes(x, y);
  std::vector<double> d(n + 3);  // secants, with two extrapolated ones at either end
  for (std::size_t i = 0; i + 1 < n; ++i) d[i + 2] = (y[i + 1] - y[i]) / (x[i + 1] - x[i]);
  d[1] = 2.0 * d[2] - d[3];
  d[0] = 2.0 * d[1] - d[2];
  d[n + 1] = 2.0 * d[n] - d[n - 1];
  d[n + 2] = 2.0 * d[n + 1] - d[n];
  std::vector<double> slopes(n);
  for (std::size_t i = 0; i < n; ++i) {
    const double right = std::abs(d[i + 3] - d[i + 2]) + 0.5 * std::abs(d[i + 3] + d[i + 2]);
    const double left = std::abs(d[i + 1] - d[i]) + 0.5 * std::abs(d[i + 1] + d[i]);
    const double sum = left + right;
    slopes[i] = sum > 0.0 ? (right * d[i + 1] + left * d[i + 2]) / sum : 0.0;
  }
  return slopes;
}

/// First derivatives of the natural cubic spline: a tridiagonal system, diagonally dominant.
std::vector<double> naturalSlopes(const std::vector<double>& x, const std::vector<double>& y) {
  const std::size_t n = x.size();
  std::vector<double> diagonal(n, 2.0);
  std::vector<double> above(n, 0.0);
  std::vector<double> slopes(n);
  const auto h = [&](std::size_t i) { return x[i + 1] - x[i]; };
  const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / h(i); };
  above[0] = 1.0;
  slopes[0] = 3.0 * secant(0);
  for (std::size_t i = 1; i < n; ++i) {
    const bool isEnd = i + 1 == n;
    const double below = isEnd ? 1.0 : h(i) / (h(i - 1) + h(i));
    above[i] = isEnd ? 0.0 : 1.0 - below;
    const double right =
        isEnd ? 3.0 * secant(i - 1) : 3.0 * (below * secant(i - 1) + above[i] * secant(i));
    const double factor = below / diagonal[i - 1];
    diagonal[i] -= factor * above[i - 1];
    slopes[i] = right - factor * slopes[i - 1];
  }
  slopes[n - 1] /= diagonal[n - 1];
  for (std::size_t i = n - 1; i-- > 0;) {
    slopes[i] = (slopes[i] - above[i] * slopes[i + 1]) / diagonal[i];
  }
  return slopes;
}

/// For each node the slope of the line to the next one.
std::vector<double> secantsOf(const std::vector<double>& x, const std::vector<double>& y) {
  std::vector<double> slopes;
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    slopes.push_back((y[i + 1] - y[i]) / (x[i + 1] - x[i]));
  }
  slopes.push_back(slopes.back());
  return slopes;
}

std::vector<double> slopesAt(
    std::span<const double> ofData,
    std::span<const std::size_t> nodes,
    const std::vector<double>& x,
    const std::vector<double>& y,
    SplineKind kind) {
  switch (kind) {
    case SplineKind::HermiteDataSlope: {
      std::vector<double> slopes;
      for (const std::size_t node : nodes) slopes.push_back(ofData[node]);
      return slopes;
    }
    case SplineKind::Pchip:
      return monotoneSlopes(x, y);
    case SplineKind::Makima:
      return makimaSlopes(x, y);
    case SplineKind::NaturalCubic:
      return naturalSlopes(x, y);
    case SplineKind::Linear:
      return secantsOf(x, y);
  }
  return {};
}

}  // namespace

std::vector<double> dataSlopes(const SampledCurve& curve) {
  const auto& x = curve.x;
  const auto& y = curve.y;
  const std::size_t n = x.size();
  const auto secant = [&](std::size_t i) { return (y[i + 1] - y[i]) / (x[i + 1] - x[i]); };
  std::vector<double> slopes(n);
  // The slope at an end, from the parabola through the three samples nearest to that end.
  const auto endSlope = [&](std::size_t near, std::size_t next, double h0, double h1) {
    return ((2.0 * h0 + h1) * secant(near) - h0 * secant(next)) / (h0 + h1);
  };
  const bool isLine = n < 3;
  slopes.front() = isLine ? secant(0) : endSlope(0, 1, x[1] - x[0], x[2] - x[1]);
  slopes.back() =
      isLine ? secant(0) : endSlope(n - 2, n - 3, x[n - 1] - x[n - 2], x[n - 2] - x[n - 3]);
  for (std::size_t i = 1; i + 1 < n; ++i) {
    const double left = x[i] - x[i - 1];
    const double right = x[i + 1] - x[i];
    slopes[i] = (right * secant(i - 1) + left * secant(i)) / (left + right);
  }
  return slopes;
}

double Spline::at(double x) const noexcept {
  if (!(x > segments.front().begin)) return nodes.front().force;
  if (x >= segments.back().end) return nodes.back().force;
  const auto after =
      std::upper_bound(segments.begin(), segments.end(), x, [](double value, const auto& segment) {
        return value < segment.begin;
      });
  return (after - 1)->at(x).force;
}

Spline splineOf(std::vector<models::HermiteNode<double>> nodes) {
  Spline spline{.nodes = std::move(nodes)};
  for (std::size_t i = 0; i + 1 < spline.nodes.size(); ++i) {
    spline.segments.push_back(
        models::CubicSegment<double>::between(spline.nodes[i], spline.nodes[i + 1]));
  }
  return spline;
}

Spline splineThrough(
    const SampledCurve& curve,
    std::span<const double> slopes,
    std::span<const std::size_t> nodes,
    SplineKind kind) {
  std::vector<double> x;
  std::vector<double> y;
  for (const std::size_t node : nodes) {
    x.push_back(curve.x[node]);
    y.push_back(curve.y[node]);
  }
  const auto chosen = slopesAt(slopes, nodes, x, y, kind);
  Spline spline;
  for (std::size_t i = 0; i < x.size(); ++i) spline.nodes.push_back({x[i], y[i], chosen[i]});
  for (std::size_t i = 0; i + 1 < x.size(); ++i) {
    auto end = spline.nodes[i + 1];
    if (kind == SplineKind::Linear) end.slope = chosen[i];
    spline.segments.push_back(models::CubicSegment<double>::between(spline.nodes[i], end));
  }
  return spline;
}

ApproximationError errorOf(const SampledCurve& curve, const Spline& spline, double floor) {
  ApproximationError error;
  double squares = 0.0;
  double mean = 0.0;
  for (const double y : curve.y) mean += y / static_cast<double>(curve.size());
  double spread = 0.0;
  std::size_t piece = 0;
  for (std::size_t i = 0; i < curve.size(); ++i) {
    const double x = curve.x[i];
    const double y = curve.y[i];
    while (piece + 1 < spline.segments.size() && spline.segments[piece].end < x) ++piece;
    const double off = std::abs(spline.segments[piece].at(x).force - y);
    if (y != 0.0 && off / std::abs(y) > error.published) {
      error.published = off / std::abs(y);
      error.publishedPosition = x;
    }
    const double floored = off / std::max(std::abs(y), floor);
    if (floored > error.floored) {
      error.floored = floored;
      error.flooredPosition = x;
    }
    error.largest = std::max(error.largest, off);
    squares += off * off;
    spread += (y - mean) * (y - mean);
  }
  error.rms = std::sqrt(squares / static_cast<double>(curve.size()));
  error.rSquared = spread > 0.0 ? 1.0 - squares / spread : 1.0;
  return error;
}

}  // namespace haptics::reaming
