#include "haptics/reaming/material/sampled_curve.h"

#include <cstddef>

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

namespace {

/// Resamples a curve at increasing x.
class Reader {
 public:
  Reader(const SampledCurve& curve, double half) : curve_(curve), half_(half) {}

  /// The mean of the samples within half a step of @p x; linearly interpolated if there are none.
  double at(double x) {
    while (before_ + 2 < curve_.size() && curve_.x[before_ + 1] < x) ++before_;
    double sum = 0.0;
    double near = 0.0;
    for (std::size_t j = before_ + 1; j-- > 0 && curve_.x[j] >= x - half_;) {
      sum += curve_.y[j];
      near += 1.0;
    }
    for (std::size_t j = before_ + 1; j < curve_.size() && curve_.x[j] < x + half_; ++j) {
      sum += curve_.y[j];
      near += 1.0;
    }
    if (near > 0.0) return sum / near;
    const std::size_t k = before_;
    const double part = (x - curve_.x[k]) / (curve_.x[k + 1] - curve_.x[k]);
    return curve_.y[k] + part * (curve_.y[k + 1] - curve_.y[k]);
  }

 private:
  const SampledCurve& curve_;
  double half_;
  std::size_t before_ = 0;
};

}  // namespace

SampledCurve normalised(const SampledCurve& curve, std::size_t count) {
  SampledCurve result;
  const double largestX = curve.x.back();
  Reader reader(curve, 0.5 * largestX / static_cast<double>(count - 1));
  for (std::size_t i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / static_cast<double>(count - 1);
    const double read = reader.at(share * largestX);
    result.x.push_back(share);
    result.y.push_back(i == 0 ? curve.y.front() : i + 1 == count ? curve.y.back() : read);
  }
  return result;
}

SampledCurve resampled(const SampledCurve& curve, double largestX, std::size_t count) {
  SampledCurve result;
  const auto last = static_cast<double>(count - 1);
  Reader reader(curve, 0.5 * largestX / last);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = static_cast<double>(i) / last * largestX;
    if (x > curve.x.back()) break;
    const double read = reader.at(x);
    result.x.push_back(x);
    result.y.push_back(i == 0 ? curve.y.front() : read);
  }
  return result;
}

double endValueOf(const SampledCurve& curve, double width) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = curve.size(); i-- > 0;) {
    if (count > 0.0 && curve.x[i] < curve.x.back() - width) break;
    sum += curve.y[i];
    count += 1.0;
  }
  return sum / count;
}

}  // namespace haptics::reaming
