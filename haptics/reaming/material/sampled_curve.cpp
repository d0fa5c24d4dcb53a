#include "haptics/reaming/material/sampled_curve.h"

#include <algorithm>
#include <cstddef>
#include <numeric>

namespace haptics::reaming {

SampledCurve curveOver(std::span<const double> displacement, std::span<const double> values) {
  SampledCurve curve;
  double count = 0.0;
  for (std::size_t i = 0; i < displacement.size(); ++i) {
    const double x = displacement[i] - displacement.front();
    const bool hasGoneOn = curve.x.empty() || x > curve.x.back();
    if (hasGoneOn) {
      curve.x.push_back(x);
      curve.y.push_back(values[i]);
      count = 1.0;
    } else {
      count += 1.0;
      curve.y.back() += (values[i] - curve.y.back()) / count;
    }
  }
  return curve;
}

SampledCurve normalised(const SampledCurve& curve, std::size_t count) {
  SampledCurve result;
  const double whole = curve.x.back();
  const double half = 0.5 * whole / static_cast<double>(count - 1);
  std::size_t k = 0;
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double x = share * whole;
    while (k + 2 < curve.size() && curve.x[k + 1] < x) ++k;
    double sum = 0.0;
    double near = 0.0;
    for (std::size_t j = k + 1; j-- > 0 && curve.x[j] >= x - half;) {
      sum += curve.y[j];
      near += 1.0;
    }
    for (std::size_t j = k + 1; j < curve.size() && curve.x[j] < x + half; ++j) {
      sum += curve.y[j];
      near += 1.0;
    }
    result.x.push_back(share);
    if (i == 0 || i + 1 == count) {
      result.y.push_back(i == 0 ? curve.y.front() : curve.y.back());
    } else if (near > 0.0) {
      result.y.push_back(sum / near);
    } else {
      const double part = (x - curve.x[k]) / (curve.x[k + 1] - curve.x[k]);
      result.y.push_back(curve.y[k] + part * (curve.y[k + 1] - curve.y[k]));
    }
  }
  return result;
}

namespace {

Envelope pointwise(std::span<const SampledCurve> curves) {
  Envelope envelope{curves[0], curves[0], curves[0]};
  for (std::size_t i = 0; i < curves[0].size(); ++i) {
    double sum = 0.0;
    for (const auto& curve : curves) {
      envelope.minimum.y[i] = std::min(envelope.minimum.y[i], curve.y[i]);
      envelope.maximum.y[i] = std::max(envelope.maximum.y[i], curve.y[i]);
      sum += curve.y[i];
    }
    envelope.average.y[i] = sum / static_cast<double>(curves.size());
  }
  return envelope;
}

}  // namespace

Envelope envelopeOf(std::span<const SampledCurve> curves, EnvelopeRule rule) {
  if (rule == EnvelopeRule::Pointwise) return pointwise(curves);
  std::vector<std::size_t> order(curves.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  const auto total = [&](std::size_t i) {
    return std::accumulate(curves[i].y.begin(), curves[i].y.end(), 0.0);
  };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    return total(a) < total(b);
  });
  return {curves[order.front()], curves[order[order.size() / 2]], curves[order.back()]};
}

}  // namespace haptics::reaming
