#pragma once

#include <string>
#include <vector>

#include <QTableWidget>

#include "haptics/devices/device.h"

namespace study::gui {

/// A finding about one part: a device, the texts, or the timing.
struct FindingLine {
  std::string part;
  haptics::devices::CheckResult found;
  std::string details{};  ///< what was measured, for readers who know the units; may be empty
  bool isTested = true;   ///< false: there was nothing to test
};

/// Findings as a table, each with what to do: the part with the worst finding first, and in it the
/// worst.
class FindingsTable final : public QTableWidget {
  Q_OBJECT

 public:
  explicit FindingsTable(QWidget* parent);

  void show(std::vector<FindingLine> lines, bool hasDetails = false);
  using QWidget::show;

 private:
  void fitRows();
};

}  // namespace study::gui
