#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QDialog>
#include <QLabel>
#include <QPushButton>

#include "haptics/devices/device.h"

namespace study::gui {

/// Shows the findings of a check of the devices before a session: the worst first, each with what
/// to do.
class FindingsDialog final : public QDialog {
  Q_OBJECT

 public:
  /// The findings about one device.
  struct PartFindings {
    std::string part;
    std::vector<haptics::devices::CheckResult> results;
  };

  /// Whether the dialog only shows the findings or also asks whether to begin despite failures.
  enum class Question { Nothing, StartDespiteFailures };

  /// Called by the button *Check again*.
  using CheckAgain = std::function<std::vector<PartFindings>()>;

  FindingsDialog(
      const std::vector<PartFindings>& found,
      Question asks,
      const CheckAgain& checkAgain,
      QWidget* parent);

  static bool hasFailed(const std::vector<PartFindings>& found);

 private:
  void show(const std::vector<PartFindings>& found);
  void openHelp();
  using QDialog::show;

  QLabel* verdict_;
  QWidget* consequences_;  ///< of a start despite failures
  class FindingsTable* table_;
  QPushButton* start_;  ///< hidden unless the dialog asks whether to start anyway
};

}  // namespace study::gui
