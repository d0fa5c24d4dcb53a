#pragma once

#include <QPainter>
#include <QString>

#include "study/report/figures/axis_scale.h"

namespace study::report {

/// A figure of rows with names on the left, a value axis along the bottom, and texts on the right.
/// Bars, dots and intervals are drawn on it.
class RowsCanvas {
 public:
  static constexpr double kWidth = 820.0;
  static constexpr double kHeading = 26.0;
  static constexpr double kAxis = 48.0;  ///< height of ticks and title

  /// @param left, right  widths of names and texts [px]
  RowsCanvas(QPainter& painter, double left, double right, AxisScale scale)
      : painter_(painter), left_(left), right_(kWidth - right), scale_(std::move(scale)) {}

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
  QPainter& painter_;
  double left_;
  double right_;
  AxisScale scale_;
};

}  // namespace study::report
