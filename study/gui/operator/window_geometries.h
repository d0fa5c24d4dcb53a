#pragma once

#include <optional>

#include <QRect>

namespace study::gui {

/// The places of the operator's and the participant's window, side by side on one screen.
struct WindowGeometries {
  QRect own;  ///< of the operator's window, which needs more room
  QRect participant;
};

/// @param screen  without the desktop's bars
/// @return std::nullopt if it has no room for two windows.
inline std::optional<WindowGeometries> windowGeometriesOn(const QRect& screen) {
  constexpr int kLeastWidthOfTwoWindows = 1800;  // [px]
  constexpr int kOperatorPercent = 56;
  if (screen.width() < kLeastWidthOfTwoWindows) return std::nullopt;
  const int own = screen.width() * kOperatorPercent / 100;
  return WindowGeometries{
      .own = {screen.left(), screen.top(), own, screen.height()},
      .participant = {screen.left() + own, screen.top(), screen.width() - own, screen.height()}};
}

/// The place of the participant's window on a screen without room for two: to the right of the
/// operator's buttons, so that the one that stops stays in sight.
/// @param screen  without the desktop's bars
/// @return std::nullopt if it has no room for that either.
inline std::optional<QRect> placeBesideStop(const QRect& screen) {
  constexpr int kButtons = 500;         // [px] at the left of the operator's window
  constexpr int kLeastPageWidth = 683;  // [px]
  if (screen.width() < kButtons + kLeastPageWidth) return std::nullopt;
  return screen.adjusted(kButtons, 0, 0, 0);
}

}  // namespace study::gui
