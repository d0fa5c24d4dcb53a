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
/// in a narrow one names and texts stand above their row. Headings and rows are painted from top to
/// bottom; bars, dots and intervals are drawn on the row that is reached.
class RowsCanvas {
 public:
  static constexpr double kHeading = 24.0;  ///< height of a heading
  static constexpr double kAxis = 48.0;     ///< height of the axis: ticks and title

  RowsCanvas(
      QPainter& painter,
      const FigureFormat& format,
      const RowMeasures& rows,
      const AxisScale& scale)
      : painter_(painter),
        isNarrow_(format.isNarrow()),
        rowHeight_(rowHeight(format, rows)),
        drawing_(rows.height),
        width_(format.layoutWidth()),
        left_(isNarrow_ ? kNarrowEnd : rows.names),
        right_(width_ - (isNarrow_ ? kNarrowEnd : rows.texts)),
        scale_(scale) {}

  /// The height of a heading with @p count rows.
  static double blockHeight(
      const FigureFormat& format, std::size_t count, const RowMeasures& rows) {
    return kHeading + static_cast<double>(count) * rowHeight(format, rows);
  }
  /// The height of @p count rows.
  double heightOf(std::size_t count) const { return static_cast<double>(count) * rowHeight_; }

  /// The upper edge of what is painted next.
  double y() const noexcept { return y_; }
  /// The middle of the row's drawing, which is below its name in a narrow figure.
  double middle() const noexcept { return y_ + rowHeight_ - drawing_ / 2; }
  void nextRow() { skip(rowHeight_); }
  void skip(double height) { y_ += height; }

  double x(double value) const { return left_ + (right_ - left_) * scale_.place(value); }
  double left() const noexcept { return left_; }
  double right() const noexcept { return right_; }

  /// A heading; what follows is below it.
  void heading(const std::string& text);
  /// The row's name, and its text on the right.
  void name(const std::string& text);
  void words(const std::string& text);

  /// Grid lines from @p top to @p bottom, and the axis below.
  void axis(double top, double bottom, const std::string& title, const QString& suffix = {});
  /// A dark line at @p value.
  void reference(double value, double top, double bottom, Qt::PenStyle style = Qt::SolidLine);
  /// A line between two values, with marks at its ends.
  void interval(double low, double high, double y, const QColor& colour, double thickness);
  void dot(double value, double y, const QColor& colour, double radius);

 private:
  static constexpr double kNameLine = 18.0;  // height of a name above its row, in a narrow figure
  static constexpr double kNarrowEnd = 20.0;

  static double rowHeight(const FigureFormat& format, const RowMeasures& rows) {
    return rows.height + (format.isNarrow() ? kNameLine : 0.0);
  }

  QPainter& painter_;
  bool isNarrow_;
  double rowHeight_;
  double drawing_;  // height of a row without its name
  double width_;
  double left_;
  double right_;
  AxisScale scale_;
  double y_ = 0.0;
};

}  // namespace study::report
