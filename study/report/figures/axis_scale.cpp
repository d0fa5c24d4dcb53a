#include "study/report/figures/axis_scale.h"

#include <algorithm>
#include <cmath>

namespace study::report {
namespace {

QString powerOfTen(int decade) {
  if (decade >= 0 && decade <= 3) return QString::number(static_cast<int>(std::pow(10, decade)));
  if (decade == -1) return QStringLiteral("0.1");
  static const QString kDigits = QStringLiteral("⁰¹²³⁴⁵⁶⁷⁸⁹");
  QString raised = decade < 0 ? QStringLiteral("⁻") : QString();
  for (const QChar digit : QString::number(std::abs(decade))) {
    raised += kDigits[digit.digitValue()];
  }
  return QStringLiteral("10") + raised;
}

}  // namespace

AxisScale::AxisScale(const ChartAxis& axis, double least, double most)
    : isLog_(axis.isLogarithmic) {
  least_ = forward(axis.least.value_or(least));
  most_ = forward(axis.most.value_or(most));
  const double margin = 0.03 * (most_ - least_);
  if (!axis.least && (isLog_ || least < 0.0)) least_ -= margin;
  if (!axis.most) most_ += margin;
  if (!(most_ > least_)) {
    least_ -= 0.5;
    most_ += 0.5;
  }
}

bool AxisScale::shows(double value) const {
  return std::isfinite(value) && (!isLog_ || value > 0.0);
}

double AxisScale::forward(double value) const {
  return isLog_ ? std::log10(value) : value;
}

std::vector<AxisScale::Tick> AxisScale::ticks(int wanted) const {
  return isLog_ ? decades() : steps(wanted);
}

std::vector<AxisScale::Tick> AxisScale::decades() const {
  std::vector<Tick> ticks;
  // the tolerance keeps the decades at the ends of the axis in spite of rounding errors
  const int first = static_cast<int>(std::ceil(least_ - 1e-9));
  const int last = static_cast<int>(std::floor(most_ + 1e-9));
  // at most nine labels, so that they do not overlap
  const int stride = std::max(1, (last - first + 7) / 8);
  const bool isShort = most_ - least_ < 1.6;
  // one decade early: its 2 and 5 may lie on a short axis
  for (int decade = first - 1; decade <= last; decade += stride) {
    const double power = std::pow(10.0, decade);
    if (decade >= first) ticks.push_back({power, powerOfTen(decade)});
    if (!isShort) continue;
    for (const double factor : {2.0, 5.0}) {
      const double place = std::log10(factor * power);
      const bool isWithin = place >= least_ && place <= most_;
      if (isWithin) ticks.push_back({factor * power, QString::number(factor * power)});
    }
  }
  return ticks;
}

std::vector<AxisScale::Tick> AxisScale::steps(int wanted) const {
  std::vector<Tick> ticks;
  const double rough = (most_ - least_) / wanted;
  const double power = std::pow(10.0, std::floor(std::log10(rough)));
  double step = 10.0 * power;
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power >= rough) {
      step = factor * power;
      break;
    }
  }
  for (double at = std::ceil(least_ / step - 1e-9) * step; at <= most_ + 1e-9 * step; at += step) {
    // near zero, the sum of steps leaves a rounding error, which would be the label
    const double value = std::abs(at) < 1e-9 * step ? 0.0 : at;
    ticks.push_back({value, QString::number(value).replace(u'-', u'−')});
  }
  return ticks;
}

}  // namespace study::report
