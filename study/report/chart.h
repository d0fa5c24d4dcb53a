#pragma once

#include <optional>
#include <string>
#include <vector>

namespace study::report {

/// A point of a chart; what a logarithmic axis cannot show is left out.
struct ChartPoint {
  double x = 0.0;
  double y = 0.0;
  std::optional<double> xHigh;  ///< a bar from x to here
  std::string label;            ///< beside the marker
};

/// Points that belong together.
struct ChartSeries {
  enum class Style { Line, Dashed, Markers, LineAndMarkers };

  std::string title;  ///< for the legend; none where empty
  Style style = Style::Line;
  std::vector<ChartPoint> points;
  std::optional<int> colour;  ///< a category; the series' place where it is not said
};

/// An axis reaches over all points, unless it is said how far.
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
