#pragma once

#include <cstddef>
#include <string>

#include "haptics/reaming/material/sampled_curve.h"
#include "study/report/chart.h"

namespace study::app {

inline constexpr double kMillimetres = 1000.0;  ///< in a metre

/// A regular selection of at most about @p most of @p count points, so that a figure of 200,000
/// samples can be opened.
template <typename X, typename Y>
report::ChartSeries thinned(
    const std::string& title, std::size_t count, X x, Y y, std::size_t most = 3000) {
  report::ChartSeries series{.title = title};
  const std::size_t stride = count / most + 1;
  for (std::size_t i = 0; i < count; i += stride) series.points.push_back({x(i), y(i)});
  return series;
}

/// A curve with x multiplied by @p scale.
inline report::ChartSeries lineOf(
    const std::string& title,
    const haptics::reaming::SampledCurve& curve,
    double scale,
    std::size_t most = 3000) {
  return thinned(
      title,
      curve.size(),
      [&](std::size_t i) { return scale * curve.x[i]; },
      [&](std::size_t i) { return curve.y[i]; },
      most);
}

}  // namespace study::app
