#pragma once

#include <string>
#include <vector>

#include <QDialog>

#include "haptics/devices/device.h"

namespace study::gui {

/// What a check before a session has found, of devices and texts: PASS, WARN, FAIL, what was
/// measured, what to do.
class FindingsDialog final : public QDialog {
  Q_OBJECT

 public:
  /// What was found of one device, or of the texts.
  struct Found {
    std::string part;
    std::vector<haptics::devices::CheckResult> results;
  };

  /// Whether to show them, or also to ask whether to go on without what has failed.
  enum class Asks { Nothing, GoWithout };

  FindingsDialog(const std::vector<Found>& found, Asks asks, QWidget* parent);

  static bool hasFailed(const std::vector<Found>& found);
};

}  // namespace study::gui
