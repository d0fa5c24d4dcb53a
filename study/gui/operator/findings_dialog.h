#pragma once

#include <string>
#include <vector>

#include <QDialog>

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
  enum class Asks { Nothing, GoWithout };

  FindingsDialog(const std::vector<Found>& found, Asks asks, QWidget* parent);

  static bool hasFailed(const std::vector<Found>& found);
};

}  // namespace study::gui
