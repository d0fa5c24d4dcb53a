#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <map>

#include <QColor>
#include <QImage>

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

/// How many pixels of @p picture have a colour, by colour.
inline std::map<QRgb, std::ptrdiff_t> coloursOf(const QImage& picture) {
  const QImage pixels = picture.convertToFormat(QImage::Format_ARGB32);
  std::map<QRgb, std::ptrdiff_t> counts;
  for (int y = 0; y < pixels.height(); ++y) {
    const auto* line = reinterpret_cast<const QRgb*>(pixels.constScanLine(y));
    for (int x = 0, end = 0; x < pixels.width(); x = end) {  // runs of one colour
      while (end < pixels.width() && line[end] == line[x]) ++end;
      counts[line[x]] += end - x;
    }
  }
  return counts;
}

}  // namespace study::gui
