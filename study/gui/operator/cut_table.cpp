#include "study/gui/operator/cut_table.h"

#include <algorithm>

#include <QHeaderView>

#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/read_only_table.h"

namespace study::gui {
namespace {

using haptics::engine::CutDetector;
using haptics::engine::TickSample;

enum Column { kContact, kYield, kBottom, kOpening, kDepth, kPeak, kTime, kColumns };

QString describe(const CutDetector::Landmark& landmark, const TravelScale& travel) {
  if (!landmark.found) return QStringLiteral("—");
  return QStringLiteral("%1 · %2")
      .arg(landmark.force, 0, 'f', 2)
      .arg(travel.factor * landmark.travel, 0, 'f', 1);
}

int columnOf(CutDetector::Event event) {
  switch (event) {
    case CutDetector::Event::Interception:
      return kContact;
    case CutDetector::Event::Yield:
      return kYield;
    case CutDetector::Event::BottomOut:
      return kBottom;
    case CutDetector::Event::Opening:
      return kOpening;
    default:
      return -1;
  }
}

}  // namespace

CutTable::CutTable(QWidget* parent) : QTableWidget(0, kColumns, parent) {
  setObjectName(QStringLiteral("cuts"));
  horizontalHeader()->setStretchLastSection(true);
  setSelectionMode(QAbstractItemView::NoSelection);
  makeReadOnly(*this);
  verticalHeader()->show();  // the number of the cut
  setFocusPolicy(Qt::NoFocus);
}

void CutTable::begin(const haptics::devices::DeviceKind& device, double rate) {
  detector_ = CutDetector(device.stroke);
  rate_ = rate;
  travel_ = travelScaleOf(device);
  // A cut through a meniscus has landmarks; a stroke in bone has a depth and a duration.
  const bool isCut = device.tissue == haptics::devices::Tissue::Meniscus;
  for (const int column : {kContact, kYield, kBottom, kOpening}) setColumnHidden(column, !isCut);
  for (const int column : {kDepth, kTime}) setColumnHidden(column, isCut);
  writeHeads(isCut);
  setAccessibleName(
      tr("%1 of this trial").arg(capitalised(asText(device.strokesName.in(deskLanguage())))));
  cut_ = 0;
  contact_.reset();
  setRowCount(0);
}

/// The heads, with what a cell has below the name of a landmark, and columns as wide as heads and
/// cells need: the table is narrow beside a participant's window.
void CutTable::writeHeads(bool isCut) {
  const auto unit = travel_.suffix.trimmed();
  const auto ofDevice = QStringLiteral("N · ") + unit;
  const auto units = u'\n' + (unit.isEmpty() ? tr("N · travel") : ofDevice);
  setHorizontalHeaderLabels(
      {tr("Interception") + units,
       tr("Yield") + units,
       tr("Bottom-out") + units,
       tr("Opening") + units,
       tr("Depth"),
       isCut ? tr("Largest force").replace(u' ', u'\n') : tr("Largest force"),
       tr("Time")});
  for (const int column : {kContact, kYield, kBottom, kOpening}) {
    horizontalHeaderItem(column)->setToolTip(tr("Force, and the travel at it"));
  }
  constexpr int kAround = 10;  // [px] of a cell
  const int cell = fontMetrics().horizontalAdvance(tr("after %1 s").arg(QStringLiteral("9.99")));
  for (int column = 0; column < (isCut ? kPeak : kTime); ++column) {  // the last takes the rest
    setColumnWidth(column, std::max(cell + kAround, horizontalHeader()->sectionSizeHint(column)));
  }
}

void CutTable::add(const TickSample& sample) {
  if ((sample.marks & (TickSample::Invalid | TickSample::Stopped)) != 0) return;
  const bool isSettling = (sample.marks & TickSample::SoftStart) != 0;
  const auto event = detector_.feed(sample.travel, sample.force, isSettling);
  if (event == CutDetector::Event::Nothing) return;
  const double time = static_cast<double>(sample.tick) / rate_;
  if (event == CutDetector::Event::Interception) contact_ = time;
  if (event != CutDetector::Event::CutCompleted) {
    write(columnOf(event), tr("after %1 s").arg(time, 0, 'f', 2));
    return;
  }
  const auto& cut = detector_.lastCut();
  write(kContact, describe(cut.interception, travel_));
  write(kYield, describe(cut.yield, travel_));
  write(kBottom, describe(cut.bottomOut, travel_));
  write(kOpening, describe(cut.opening, travel_));
  write(kDepth, tr("%1%2").arg(travel_.factor * cut.largestTravel, 0, 'f', 1).arg(travel_.suffix));
  write(kPeak, tr("%1 N").arg(cut.peakForce, 0, 'f', 2));
  write(kTime, contact_ ? tr("%1 s").arg(time - *contact_, 0, 'f', 2) : QStringLiteral("—"));
  contact_.reset();
  ++cut_;
}

/// Writes a cell in the row of the current cut.
void CutTable::write(int column, const QString& words) {
  if (rowCount() <= cut_) {
    setRowCount(cut_ + 1);
    scrollToBottom();
  }
  if (item(cut_, column) == nullptr) setItem(cut_, column, new QTableWidgetItem);
  item(cut_, column)->setText(words);
}

}  // namespace study::gui
