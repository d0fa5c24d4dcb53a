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
class HardwareRig;
class Rig;
}  // namespace study

namespace study::gui {

/// How the instruments of this study are: a line each, and a button that checks them. Of virtual
/// instruments it says just that.
class DevicePanel final : public QWidget {
  Q_OBJECT

 public:
  /// Protocol and rig outlive it.
  DevicePanel(const protocols::Protocol& protocol, Rig& rig, QWidget* parent = nullptr);

  /// While a trial runs nothing is checked.
  void setBusy(bool isBusy);

  /// Before a session: checks every device, and asks where one has failed, or anything of what was
  /// found @p otherwise; No is what Enter says. Virtual instruments are always fit.
  bool mayBegin(const std::vector<FindingsDialog::Found>& otherwise);

 public slots:
  /// Checks every device of the protocol, and shows what was found.
  void check();

 private:
  void refresh();
  /// A few seconds, during which the window draws but takes no clicks.
  std::vector<FindingsDialog::Found> listen();

  const protocols::Protocol& protocol_;
  HardwareRig* rig_;  ///< null: virtual instruments
  std::map<std::string, QLabel*> lines_;
  QPushButton* button_ = nullptr;
  QTimer timer_;
};

}  // namespace study::gui
