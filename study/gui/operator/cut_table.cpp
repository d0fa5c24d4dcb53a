#include "study/gui/operator/cut_table.h"

#include <algorithm>
#include <array>
#include <utility>

#include <QHeaderView>
#include <QPainter>

#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"
#include "study/gui/widgets/read_only_table.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

using haptics::engine::CutDetector;
using haptics::engine::TickSample;

/// Each landmark has two columns: its force, and the travel at it.
enum Column {
  kContact,
  kYield = kContact + 2,
  kBottom = kYield + 2,
  kOpening = kBottom + 2,
  kDepth = kOpening + 2,
  kPeak,
  kTime,
  kColumns
};
constexpr std::array kLandmarks{kContact, kYield, kBottom, kOpening};

/// Heads of two lines, of which the first belongs to two columns: the landmark above force and
/// travel.
class PairedHeads final : public QHeaderView {
 public:
  PairedHeads(QStringList titles, QWidget* parent)
      : QHeaderView(Qt::Horizontal, parent), titles_(std::move(titles)) {
    setDefaultAlignment(Qt::AlignLeft | Qt::AlignBottom);
  }

 protected:
  /// Paints the title of a pair with its second column, as each head fills its own background.
  void paintSection(QPainter* painter, const QRect& place, int column) const override {
    painter->save();
    QHeaderView::paintSection(painter, place, column);
    painter->restore();
    const int pair = column / 2;
    if (pair >= titles_.size() || column % 2 == 0) return;
    constexpr QMargins kCellPadding(8, 4, 0, 4);  // [px], as of the theme's heads
    const QRect both = place.adjusted(-sectionSize(column - 1), 0, 0, 0);
    auto bold = font();
    bold.setBold(true);
    painter->setFont(bold);
    painter->setPen(themeOf(*this).header.text);
    painter->drawText(
        both.marginsRemoved(kCellPadding), Qt::AlignLeft | Qt::AlignTop, titles_[pair]);
  }

 private:
  QStringList titles_;
};

}  // namespace

CutTable::CutTable(QWidget* parent)
    : QTableWidget(0, kColumns, parent),
      titles_{tr("Interception"), tr("Yield"), tr("Bottom-out"), tr("Opening")} {
  setHorizontalHeader(new PairedHeads(titles_, this));
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
  for (int column = 0; column < kDepth; ++column) setColumnHidden(column, !isCut);
  for (const int column : {kDepth, kTime}) setColumnHidden(column, isCut);
  writeHeads(isCut);
  setAccessibleName(
      tr("%1 of this trial").arg(capitalised(asText(device.strokesName.in(deskLanguage())))));
  cut_ = 0;
  contact_.reset();
  setRowCount(0);
}

/// The heads, and columns as wide as heads and cells need: the table is narrow beside a
/// participant's window.
void CutTable::writeHeads(bool isCut) {
  const auto newLine = QStringLiteral("\n");
  QStringList heads;
  for (std::size_t i = 0; i < kLandmarks.size(); ++i) {
    heads << newLine + QStringLiteral("N")
          << newLine + (travel_.suffix.isEmpty() ? tr("at") : travel_.unit);
  }
  heads << tr("Depth") << (isCut ? tr("Peak") + newLine + QStringLiteral("N") : tr("Largest force"))
        << tr("Time");
  setHorizontalHeaderLabels(heads);
  for (int column = 0; column < kDepth; ++column) {
    const auto what = column % 2 == 0 ? tr("%1: force [N]") : tr("%1: travel [%2]");
    const auto words =
        (column % 2 == 0 ? what.arg(titles_[column / 2])
                         : what.arg(titles_[column / 2], travel_.unit));
    horizontalHeaderItem(column)->setData(Qt::AccessibleTextRole, words);
    horizontalHeaderItem(column)->setToolTip(words);
  }
  constexpr int kCellPadding = 17;  // [px] of a cell
  constexpr int kAroundTitle = 11;  // [px]
  auto bold = horizontalHeader()->font();
  bold.setBold(true);
  for (int column = 0; column < kColumns; ++column) {  // the last takes the rest, too
    const int cell = fontMetrics().horizontalAdvance(QStringLiteral("99.9")) + kCellPadding;
    setColumnWidth(column, std::max(cell, horizontalHeader()->sectionSizeHint(column)));
  }
  for (std::size_t i = 0; isCut && i < kLandmarks.size(); ++i) {
    const int title =
        QFontMetrics(bold).horizontalAdvance(titles_[static_cast<int>(i)]) + kAroundTitle;
    const int second = kLandmarks[i] + 1;
    const int first = columnWidth(second - 1);
    setColumnWidth(second, std::max(columnWidth(second), title - first));
  }
}

void CutTable::add(const TickSample& sample) {
  if ((sample.marks & (TickSample::Invalid | TickSample::Stopped)) != 0) return;
  const bool isSettling = (sample.marks & TickSample::SoftStart) != 0;
  const auto event = detector_.feed(sample.travel, sample.force, isSettling);
  const double time = static_cast<double>(sample.tick) / rate_;
  if (event == CutDetector::Event::Interception) contact_ = time;
  if (event != CutDetector::Event::CutCompleted) return;
  const auto& cut = detector_.lastCut();
  write(kContact, cut.interception);
  write(kYield, cut.yield);
  write(kBottom, cut.bottomOut);
  write(kOpening, cut.opening);
  write(kDepth, tr("%1%2").arg(travel_.factor * cut.largestTravel, 0, 'f', 1).arg(travel_.suffix));
  const auto peak = QString::number(cut.peakForce, 'f', 2);
  write(kPeak, isColumnHidden(kYield) ? peak + QStringLiteral(" N") : peak);
  write(kTime, contact_ ? tr("%1 s").arg(time - *contact_, 0, 'f', 2) : QStringLiteral("—"));
  contact_.reset();
  ++cut_;
}

void CutTable::write(int column, const CutDetector::Landmark& landmark) {
  const auto none = QStringLiteral("—");
  const double travel = travel_.factor * landmark.travel;
  write(column, landmark.found ? QString::number(landmark.force, 'f', 2) : none);
  write(column + 1, landmark.found ? QString::number(travel, 'f', 1) : none);
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
