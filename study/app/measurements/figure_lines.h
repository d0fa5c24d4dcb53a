#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "haptics/filters/spectrum.h"
#include "haptics/reaming/material/sampled_curve.h"
#include "study/report/chart.h"

namespace study::app {

inline constexpr double kMillimetres = 1000.0;  ///< mm per m

/// Every n-th of @p count points, at most @p most in all, so that a figure of 200,000 samples can
/// be opened.
template <typename X, typename Y>
report::ChartSeries thinnedSeries(
    const std::string& title, std::size_t count, X x, Y y, std::size_t most = 3000) {
  report::ChartSeries series{.title = title};
  const std::size_t stride = count / most + 1;
  for (std::size_t i = 0; i < count; i += stride) series.points.push_back({x(i), y(i)});
  return series;
}

/// A curve with its x multiplied by @p scale.
inline report::ChartSeries lineOf(
    const std::string& title,
    const haptics::reaming::SampledCurve& curve,
    double scale,
    std::size_t most = 3000) {
  return thinnedSeries(
      title,
      curve.size(),
      [&](std::size_t i) { return scale * curve.x[i]; },
      [&](std::size_t i) { return curve.y[i]; },
      most);
}

/// An amplitude spectrum for logarithmic axes: the largest amplitude in each 1 % wide frequency
/// band, and at least @p least, the lower end of the axis.
inline report::ChartSeries spectrumLine(
    const std::string& title, const haptics::filters::Spectrum& spectrum, double least) {
  constexpr double kStep = 1.01;
  report::ChartSeries line{.title = title};
  double end = 0.0;
  for (std::size_t i = 1; i < spectrum.amplitude.size(); ++i) {
    const double frequency = spectrum.step * static_cast<double>(i);
    if (frequency < end) {
      line.points.back().y = std::max(line.points.back().y, spectrum.amplitude[i]);
      continue;
    }
    line.points.push_back({frequency, std::max(least, spectrum.amplitude[i])});
    end = frequency * kStep;
  }
  return line;
}

}  // namespace study::app
