#pragma once

#include <vector>

#include <QString>

#include "study/report/chart.h"

namespace study::report {

/// An axis with its ends, and where a value lies between them.
class AxisScale {
 public:
  /// @param least, most  of what is shown; an end that the axis says itself holds.
  AxisScale(const ChartAxis& axis, double least, double most);

  bool shows(double value) const;
  /// From 0 to 1 within the ends.
  double place(double value) const { return (forward(value) - least_) / (most_ - least_); }

  struct Tick {
    double value = 0.0;
    QString text;
  };
  /// Steps of 1, 2 or 5 times a power of ten, about @p wanted of them; decades where logarithmic.
  std::vector<Tick> ticks(int wanted = 7) const;

 private:
  double forward(double value) const;
  std::vector<Tick> decades() const;
  std::vector<Tick> steps(int wanted) const;

  bool isLog_;
  double least_ = 0.0;
  double most_ = 1.0;
};

}  // namespace study::report
