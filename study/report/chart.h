#pragma once

#include <optional>
#include <string>
#include <vector>

namespace study::report {

/// A point of a chart; a point that a logarithmic axis cannot show is left out.
struct ChartPoint {
  double x = 0.0;
  double y = 0.0;
  std::optional<double> xHigh;  ///< a bar from x to here
  std::string label;            ///< beside the marker
};

/// Points of one kind.
struct ChartSeries {
  enum class Style { Line, Dashed, Markers, LineAndMarkers };

  std::string title;  ///< in the legend; empty: no entry
  Style style = Style::Line;
  std::vector<ChartPoint> points;
  std::optional<int> colour;  ///< a category; std::nullopt: the index of the series
};

/// An axis covers all points, unless its ends are given.
struct ChartAxis {
  std::string title;  ///< with its unit
  bool isLogarithmic = false;
  std::optional<double> least;
  std::optional<double> most;
};

/// A figure of lines and markers on two axes.
struct Chart {
  ChartAxis x;
  ChartAxis y;
  std::vector<ChartSeries> series;
};

}  // namespace study::report
