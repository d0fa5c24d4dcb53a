#pragma once

#include <map>
#include <string>
#include <vector>

#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QWidget>

#include "protocols/model/protocol.h"
#include "study/gui/operator/findings_dialog.h"

namespace study {
class HardwareDeviceSet;
class DeviceSet;
}  // namespace study

namespace study::gui {

/// The state of the study's devices, one line each, and a button that checks them. For virtual
/// devices it only shows that they are virtual.
class DevicePanel final : public QWidget {
  Q_OBJECT

 public:
  /// Protocol and device set must outlive the panel.
  DevicePanel(const protocols::Protocol& protocol, DeviceSet& deviceSet, QWidget* parent = nullptr);

  bool usesVirtualDevices() const noexcept { return deviceSet_ == nullptr; }

  /// Disables checking while a trial runs.
  void setBusy(bool isBusy);

  /// Checks every device before a session. If one has failed, asks whether to start anyway; Enter
  /// cancels.
  /// @return whether the session may begin. Virtual devices always pass.
  bool confirmDevicesReady();

 public slots:
  /// Checks every device of the protocol and shows the findings.
  void check();

 private:
  void refresh();
  /// Measures for a few seconds. The window is repainted meanwhile but ignores clicks.
  std::vector<FindingsDialog::PartFindings> checkDevices();

  const protocols::Protocol& protocol_;
  HardwareDeviceSet* deviceSet_;  ///< nullptr: virtual devices
  std::map<std::string, QLabel*> lines_;
  QPushButton* button_ = nullptr;
  QTimer timer_;
};

}  // namespace study::gui
