#pragma once

#include <functional>
#include <string>
#include <vector>

#include <QDialog>
#include <QLabel>
#include <QPushButton>

#include "haptics/devices/device.h"

namespace study::gui {

/// Shows the findings of a check before a session, for devices and texts: PASS, WARN or FAIL, the
/// measured value, and what to do.
class FindingsDialog final : public QDialog {
  Q_OBJECT

 public:
  /// The findings about one device, or about the texts.
  struct Found {
    std::string part;
    std::vector<haptics::devices::CheckResult> results;
  };

  /// Whether the dialog only shows the findings or also asks whether to begin despite failures.
  enum class Question { Nothing, StartDespiteFailures };

  /// Called by the button *Check again*; empty: there is no such button.
  using CheckAgain = std::function<std::vector<Found>()>;

  FindingsDialog(
      const std::vector<Found>& found,
      Question asks,
      const CheckAgain& checkAgain,
      QWidget* parent);

  static bool hasFailed(const std::vector<Found>& found);

 private:
  void show(const std::vector<Found>& found);
  using QDialog::show;

  QLabel* verdict_;
  class QTableWidget* table_;
  QPushButton* start_ = nullptr;  ///< nullptr unless the dialog asks whether to start anyway
};

}  // namespace study::gui
