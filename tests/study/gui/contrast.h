#pragma once

#include <algorithm>
#include <cmath>

#include <QColor>

namespace study::gui {

inline double luminance(const QColor& colour) noexcept {
  const auto linear = [](double share) {
    return share <= 0.04045 ? share / 12.92 : std::pow((share + 0.055) / 1.055, 2.4);
  };
  return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF()) +
         0.0722 * linear(colour.blueF());
}

/// The contrast ratio of two colours, 1 to 21 (WCAG 2.1).
inline double contrast(const QColor& one, const QColor& other) noexcept {
  const double a = luminance(one);
  const double b = luminance(other);
  return (std::max(a, b) + 0.05) / (std::min(a, b) + 0.05);
}

}  // namespace study::gui
