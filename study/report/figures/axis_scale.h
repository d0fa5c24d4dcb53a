#pragma once

#include <vector>

#include <QString>

#include "study/report/chart.h"

namespace study::report {

/// Maps the values of an axis to positions along it.
class AxisScale {
 public:
  /// @param least, most  the range of the data; the axis's own ends take precedence.
  AxisScale(const ChartAxis& axis, double least, double most);

  bool shows(double value) const;
  /// The position of a value: 0 at the lower end of the axis, 1 at the upper end.
  double place(double value) const { return (forward(value) - least_) / (most_ - least_); }

  struct Tick {
    double value = 0.0;
    QString text;
  };
  /// About @p wanted ticks in steps of 1, 2 or 5 times a power of ten; if logarithmic, powers of
  /// ten, and on a short axis also 2 and 5 times these.
  std::vector<Tick> ticks(int wanted = 7) const;

 private:
  double forward(double value) const;
  /// Ticks of a logarithmic axis: powers of ten; on a short axis also 2 and 5 times these.
  std::vector<Tick> decades() const;
  /// Ticks of a linear axis, about @p wanted, at steps of 1, 2 or 5 times a power of ten.
  std::vector<Tick> steps(int wanted) const;

  bool isLog_;
  double least_ = 0.0;
  double most_ = 1.0;
};

}  // namespace study::report
