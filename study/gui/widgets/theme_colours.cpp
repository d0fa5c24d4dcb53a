#include "study/gui/widgets/theme_colours.h"

namespace study::gui {

Theme lightTheme() {
  const QColor ink("#1b1f24");
  const QColor white("#ffffff");
  return {
      .window = {QColor("#fbfbf9"), ink},
      .field = {white, ink},
      .header = {QColor("#eef0f2"), ink},
      .disabled = {QColor("#eef0f2"), QColor("#626b75")},
      .accent = {QColor("#1f5f99"), white},
      .selection = {QColor("#d8e6f3"), ink},
      .stop = {QColor("#b3261e"), white},
      .good = {QColor("#00664f"), white},
      .warn = {QColor("#f0b429"), QColor("#1b1f24")},
      .bad = {QColor("#b3261e"), white},
      .paleGood = {QColor("#e3f1ee"), ink},
      .paleWarn = {QColor("#fff1d6"), ink},
      .paleBad = {QColor("#f9dcda"), ink},
      .quiet = QColor("#59616b"),
      .link = QColor("#1f5f99"),
      .border = QColor("#7f8993"),
      .line = QColor("#d4d9de"),
      .focus = QColor("#1f5f99"),
      .force = QColor("#0072b2"),
      .travel = QColor("#c14f00"),
      .torque = QColor("#8f3f73")};
}

Theme darkTheme() {
  const QColor chalk("#e8eaed");
  const QColor night("#14181c");
  return {
      .window = {QColor("#1d2227"), chalk},
      .field = {QColor("#262c32"), chalk},
      .header = {QColor("#323a42"), chalk},
      .disabled = {QColor("#2a3037"), QColor("#9aa4ae")},
      .accent = {QColor("#7fbaf0"), night},
      .selection = {QColor("#34506b"), chalk},
      .stop = {QColor("#ff8a80"), night},
      .good = {QColor("#60d0d0"), night},
      .warn = {QColor("#f5c451"), night},
      .bad = {QColor("#ff8a80"), night},
      .paleGood = {QColor("#173d34"), chalk},
      .paleWarn = {QColor("#4a3a10"), chalk},
      .paleBad = {QColor("#55211d"), chalk},
      .quiet = QColor("#b4bcc4"),
      .link = QColor("#8cc4f5"),
      .border = QColor("#8b96a1"),
      .line = QColor("#434c55"),
      .focus = QColor("#8cc4f5"),
      .force = QColor("#56b4e9"),
      .travel = QColor("#ff9a4d"),
      .torque = QColor("#e39ac6")};
}

Theme highContrastTheme() {
  const QColor black("#000000");
  const QColor white("#ffffff");
  const QColor yellow("#ffff00");
  return {
      .window = {black, white},
      .field = {black, white},
      .header = {QColor("#1a1a1a"), yellow},
      .disabled = {black, QColor("#b0b0b0")},
      .accent = {yellow, black},
      .selection = {yellow, black},
      .stop = {QColor("#ff8578"), black},
      .good = {QColor("#70f0e0"), black},
      .warn = {QColor("#ffd700"), black},
      .bad = {QColor("#ff8578"), black},
      .paleGood = {QColor("#00332a"), white},
      .paleWarn = {QColor("#3a3000"), white},
      .paleBad = {QColor("#4a0f0a"), white},
      .quiet = QColor("#e0e0e0"),
      .link = QColor("#80d8ff"),
      .border = white,
      .line = QColor("#c0c0c0"),
      .focus = QColor("#00e5ff"),
      .force = QColor("#80d8ff"),
      .travel = QColor("#ffb454"),
      .torque = QColor("#f0b0ff")};
}

}  // namespace study::gui
