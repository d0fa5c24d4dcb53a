#include "study/gui/operator/device_panel.h"

#include <QHBoxLayout>
#include <QVBoxLayout>

#include "study/gui/widgets/background_task.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/trial/hardware_device_set.h"

namespace study::gui {
namespace {

using haptics::devices::Finding;
using PartFindings = std::vector<FindingsDialog::PartFindings>;

/// The state of a device in the operator's words. Lifecycle::Closed is not called "closed", because
/// a punch also has jaws that close.
QString describe(const haptics::devices::Device& device, haptics::devices::Wire wire) {
  using haptics::devices::Lifecycle;
  using haptics::devices::Wire;
  switch (device.lifecycle()) {
    case Lifecycle::Closed:
      return wire == Wire::Serial ? DevicePanel::tr("port not open")
                                  : DevicePanel::tr("not connected");
    case Lifecycle::Open:
      return DevicePanel::tr("connected");
    case Lifecycle::Checked:
      return DevicePanel::tr("checked");
    case Lifecycle::Armed:
      return DevicePanel::tr("ready");
    case Lifecycle::Running:
      return DevicePanel::tr("running");
    case Lifecycle::Faulted:
      return DevicePanel::tr("failed");
  }
  return {};
}

constexpr int kRefreshInterval = 500;   // [ms]
constexpr double kCheckDuration = 2.0;  // [s]

}  // namespace

DevicePanel::DevicePanel(const protocols::Protocol& protocol, DeviceSet& deviceSet, QWidget* parent)
    : QWidget(parent),
      protocol_(protocol),
      deviceSet_(dynamic_cast<HardwareDeviceSet*>(&deviceSet)) {
  auto* columns = withoutMargins<QHBoxLayout>(this);
  auto* layout = new QVBoxLayout;
  columns->addLayout(layout, 1);
  if (deviceSet_ == nullptr) {
    layout->addWidget(quietLabel(
        tr("Devices are virtual: the participant's mouse or space bar is the hand."), this));
    return;
  }
  for (const auto& need : protocol.devices) {
    auto* line = quietLabel({}, this);
    line->setObjectName(QStringLiteral("device-%1").arg(QString::fromStdString(need.id)));
    line->setWordWrap(true);
    lines_[need.id] = line;
    layout->addWidget(line);
  }
  button_ = new QPushButton(tr("Check devices…"), this);
  button_->setObjectName(QStringLiteral("check-devices"));
  button_->setProperty("role", QStringLiteral("tool"));
  columns->addWidget(button_, 0, Qt::AlignTop);
  connect(button_, &QPushButton::clicked, this, &DevicePanel::check);
  connect(&timer_, &QTimer::timeout, this, &DevicePanel::refresh);
  timer_.start(kRefreshInterval);
  refresh();
}

void DevicePanel::setBusy(bool isBusy) {
  if (button_ != nullptr) button_->setEnabled(!isBusy);
}

void DevicePanel::refresh() {
  for (const auto& [id, line] : lines_) {
    const auto* device = deviceSet_->find(id);
    const auto name = QString::fromStdString(id) + QStringLiteral(": ");
    const auto fault = device == nullptr ? tr("not in the device file") : deskText(device->fault());
    setRole(*line, fault.isEmpty() ? "quiet" : "bad");
    // A failed device is not opened again by itself: that is the operator's decision.
    const auto advice =
        device == nullptr
            ? QString()
            : QStringLiteral(". ") + tr("Once it is mended, “Check devices…” connects it again.");
    line->setText(
        fault.isEmpty() ? name + describe(*device, protocol_.device(id)->kind->wire)
                        : QStringLiteral("✖ ") + name + fault + advice);
  }
}

void DevicePanel::check() {
  const auto again = [this] { return checkDevices(); };
  FindingsDialog(again(), FindingsDialog::Question::Nothing, again, window()).exec();
}

bool DevicePanel::confirmDevicesReady() {
  if (deviceSet_ == nullptr) return true;
  const auto again = [this] { return checkDevices(); };
  const auto found = again();
  if (!FindingsDialog::hasFailed(found)) return true;
  FindingsDialog question(found, FindingsDialog::Question::StartDespiteFailures, again, window());
  return question.exec() == QDialog::Accepted;
}

PartFindings DevicePanel::checkDevices() {
  timer_.stop();  // the worker owns the device set until it is done
  PartFindings found;
  const auto checkAll = [&](const Progress& progress) {
    for (const auto& need : protocol_.devices) {
      announceProgress(progress, kUnknownShare, translated("listening to {}", need.id));
      auto* device = deviceSet_->find(need.id);
      if (device == nullptr) {
        found.push_back({need.id, {missingDevice()}});
        continue;
      }
      found.push_back({need.id, preflight(*device, &protocol_, need.id, kCheckDuration)});
    }
  };
  // No trial can begin meanwhile, because the modal dialog takes all clicks until the check is
  // over.
  const bool isDone = BackgroundTask::run(
      window(),
      tr("Devices"),
      MessageTopic::DevicesNotChecked,
      checkAll,
      BackgroundTask::Cancelling::Impossible);
  if (!isDone) {
    const auto inWords = [](const char* english) {
      return base::Message::verbatim(translated(english));
    };
    found.push_back(
        {"",
         {{Finding::Fail,
           inWords("check"),
           inWords("it did not come to its end"),
           inWords("Try again.")}}});
  }
  refresh();
  timer_.start(kRefreshInterval);
  return found;
}

}  // namespace study::gui
