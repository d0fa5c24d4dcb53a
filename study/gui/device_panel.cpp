#include "study/gui/device_panel.h"

#include <thread>

#include <QDialog>
#include <QDialogButtonBox>
#include <QEventLoop>
#include <QHeaderView>
#include <QTableWidget>
#include <QVBoxLayout>

#include "study/gui/labels.h"
#include "study/hardware_rig.h"

namespace study::gui {
namespace {

using haptics::devices::CheckResult;
using haptics::devices::Finding;
using haptics::devices::Lifecycle;

constexpr int kLookEvery = 500;     // [ms]
constexpr double kListenFor = 2.0;  // [s]

/// What was found of one device.
struct Found {
  std::string device;
  std::vector<CheckResult> results;
};

QColor colourOf(Finding finding) {
  switch (finding) {
    case Finding::Pass:
      return {0xe3, 0xf1, 0xe6};
    case Finding::Warn:
      return {0xff, 0xf1, 0xd6};
    case Finding::Fail:
      return {0xf9, 0xdc, 0xda};
  }
  return {};
}

QTableWidget* tableOf(const std::vector<Found>& found, QWidget* parent) {
  auto* table = new QTableWidget(0, 5, parent);
  table->setHorizontalHeaderLabels(
      {QObject::tr("Device"),
       QObject::tr("Result"),
       QObject::tr("What"),
       QObject::tr("Measured"),
       QObject::tr("What to do")});
  table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  table->setSelectionMode(QAbstractItemView::NoSelection);
  table->setFocusPolicy(Qt::NoFocus);
  table->setWordWrap(true);
  table->verticalHeader()->hide();
  for (const auto& device : found) {
    for (const auto& result : device.results) {
      const int row = table->rowCount();
      table->insertRow(row);
      const std::string cells[] = {
          device.device,
          haptics::devices::nameOf(result.finding),
          result.what,
          result.measured,
          result.mend};
      for (int column = 0; column < 5; ++column) {
        auto* cell = new QTableWidgetItem(QString::fromStdString(cells[column]));
        if (column == 1) cell->setBackground(colourOf(result.finding));
        table->setItem(row, column, cell);
      }
    }
  }
  table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  table->horizontalHeader()->setSectionResizeMode(3, QHeaderView::Stretch);
  table->horizontalHeader()->setSectionResizeMode(4, QHeaderView::Stretch);
  // Rows follow the widths that the long columns get when the window is shown.
  table->verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  return table;
}

void showFindings(const std::vector<Found>& found, QWidget* parent) {
  QDialog dialog(parent);
  dialog.setWindowTitle(QObject::tr("Devices"));
  auto* layout = new QVBoxLayout(&dialog);
  layout->addWidget(tableOf(found, &dialog));
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close, &dialog);
  QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  layout->addWidget(buttons);
  dialog.resize(1000, 520);
  dialog.exec();
}

}  // namespace

DevicePanel::DevicePanel(const protocols::Protocol& protocol, Rig& rig, QWidget* parent)
    : QWidget(parent), protocol_(protocol), rig_(dynamic_cast<HardwareRig*>(&rig)) {
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  if (rig_ == nullptr) {
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
  layout->addWidget(button_, 0, Qt::AlignLeft);
  connect(button_, &QPushButton::clicked, this, &DevicePanel::check);
  connect(&timer_, &QTimer::timeout, this, &DevicePanel::refresh);
  timer_.start(kLookEvery);
  refresh();
}

void DevicePanel::setBusy(bool isBusy) {
  if (button_ != nullptr) button_->setEnabled(!isBusy);
}

void DevicePanel::refresh() {
  for (const auto& [id, line] : lines_) {
    const auto* device = rig_->find(id);
    QString text = QString::fromStdString(id) + QStringLiteral(": ");
    if (device == nullptr) {
      text += tr("not in the device file");
    } else {
      const auto fault = QString::fromStdString(device->fault());
      text += QString::fromUtf8(haptics::devices::nameOf(device->lifecycle())) +
              (fault.isEmpty() ? QString() : QStringLiteral(" — ") + fault);
    }
    line->setText(text);
  }
}

void DevicePanel::check() {
  // Nobody may begin a trial meanwhile: the note takes all clicks until the devices have answered.
  QDialog note(window());
  note.setWindowModality(Qt::ApplicationModal);
  note.setWindowTitle(tr("Devices"));
  auto* layout = new QVBoxLayout(&note);
  layout->addWidget(new QLabel(tr("Listening to the devices…"), &note));
  note.show();

  timer_.stop();  // the rig belongs to the worker until it is done
  std::vector<Found> found;
  QEventLoop loop;
  std::jthread worker([&] {
    for (const auto& need : protocol_.devices) {
      auto* device = rig_->find(need.id);
      if (device == nullptr) {
        found.push_back(
            {need.id,
             {{Finding::Fail,
               "device file",
               "no device of that name",
               "Add it to the device file, or give it that id."}}});
        continue;
      }
      found.push_back({need.id, preflight(*device, &need, kListenFor)});
    }
    QMetaObject::invokeMethod(&loop, &QEventLoop::quit, Qt::QueuedConnection);
  });
  loop.exec();
  worker.join();
  note.close();
  refresh();
  timer_.start(kLookEvery);
  showFindings(found, window());
}

}  // namespace study::gui
