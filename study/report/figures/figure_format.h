#pragma once

#include <optional>

namespace study::report {

/// The size of figures on paper. Figures are laid out in px with letters 13 px high; a narrow one
/// has names above its rows and legends below its plot, so that letters keep their size.
struct FigureFormat {
  std::optional<double> width;  ///< [mm]; std::nullopt: 820 px, as in a report
  double font = kUsualFont;     ///< of all letters [pt]

  static constexpr double kUsualFont = 9.75;    // 13 px at 96 dpi
  static constexpr double kUsualWidth = 820.0;  // [px]
  static constexpr double kNarrow = 600.0;      // [px]

  /// The size on paper of a px of the layout [1/96 in].
  double scale() const { return font / kUsualFont; }
  double layoutWidth() const { return width ? *width / 25.4 * 96.0 / scale() : kUsualWidth; }
  bool isNarrow() const { return layoutWidth() < kNarrow; }
};

}  // namespace study::report
