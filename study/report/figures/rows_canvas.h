#pragma once

#include <QPainter>
#include <QString>

#include "study/report/figures/axis_scale.h"
#include "study/report/figures/figure_format.h"

namespace study::report {

/// The sizes of the parts of a figure of rows [px].
struct RowMeasures {
  double names;   ///< width, on the left
  double texts;   ///< width, on the right
  double height;  ///< of a row
};

/// A figure of rows with names on the left, a value axis along the bottom, and texts on the right;
/// in a narrow one names and texts stand above their row. Bars, dots and intervals are drawn on it.
class RowsCanvas {
 public:
  static constexpr double kHeading = 24.0;  ///< height of a heading
  static constexpr double kAxis = 48.0;     ///< height of the axis: ticks and title

  static constexpr double kNameLine = 18.0;  ///< height of a name above its row, in a narrow figure

  RowsCanvas(
      QPainter& painter,
      const FigureFormat& format,
      const RowMeasures& rows,
      const AxisScale& scale)
      : painter_(painter),
        isNarrow_(format.isNarrow()),
        width_(format.layoutWidth()),
        left_(isNarrow_ ? kNarrowEnd : rows.names),
        right_(width_ - (isNarrow_ ? kNarrowEnd : rows.texts)),
        scale_(scale) {}

  /// The height of a row with its name.
  static double rowHeight(const FigureFormat& format, double height) {
    return height + (format.isNarrow() ? kNameLine : 0.0);
  }
  /// The height of a heading with @p rows rows of @p height.
  static double blockHeight(const FigureFormat& format, std::size_t rows, double height) {
    return kHeading + static_cast<double>(rows) * rowHeight(format, height);
  }
  /// The upper edge of a row's drawing, for a row whose upper edge is @p y: below its name in a
  /// narrow figure.
  double drawingOf(double y) const { return isNarrow_ ? y + kNameLine : y; }
  bool isNarrow() const noexcept { return isNarrow_; }

  double x(double value) const { return left_ + (right_ - left_) * scale_.place(value); }
  double left() const noexcept { return left_; }
  double right() const noexcept { return right_; }

  void heading(const std::string& text, double y);
  void name(const std::string& text, double y, double height);
  void words(const std::string& text, double y, double height);

  /// Grid lines from @p top to @p bottom, and the axis below.
  void axis(double top, double bottom, const std::string& title, const QString& suffix = {});
  /// A dark line at @p value.
  void reference(double value, double top, double bottom, Qt::PenStyle style = Qt::SolidLine);
  /// A line between two values, with marks at its ends.
  void interval(double low, double high, double y, const QColor& colour, double thickness);
  void dot(double value, double y, const QColor& colour, double radius);

 private:
  static constexpr double kNarrowEnd = 20.0;

  QPainter& painter_;
  bool isNarrow_;
  double width_;
  double left_;
  double right_;
  AxisScale scale_;
};

}  // namespace study::report
