#include "study/gui/home/study_list.h"

#include <algorithm>
#include <array>

#include <QHeaderView>
#include <QPainter>
#include <QStringList>
#include <QStyledItemDelegate>
#include <QTimer>

#include "study/gui/widgets/read_only_table.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

constexpr int kLinesRole = Qt::UserRole + 1;  ///< title, place and progress
constexpr int kBrokenRole = Qt::UserRole + 2;

// [px]
constexpr int kGapBetweenRows = 6;
constexpr int kPaddingX = 16;
constexpr int kPaddingY = 12;
constexpr int kGapBetweenLines = 3;
constexpr int kAboveBar = 6;
constexpr int kBarHeight = 6;
constexpr double kCorner = 8.0;

QColor mixed(const QColor& ground, const QColor& ink, double share) {
  const auto part = [share](int a, int b) { return static_cast<int>(a + share * (b - a)); };
  return {
      part(ground.red(), ink.red()),
      part(ground.green(), ink.green()),
      part(ground.blue(), ink.blue())};
}

QFont boldOf(const QFont& font) {
  QFont bold = font;
  bold.setWeight(QFont::DemiBold);
  return bold;
}

int heightOfText(const QFont& font, int width, const QString& text) {
  constexpr int kEndless = 10'000;
  return QFontMetrics(font)
      .boundingRect(QRect(0, 0, width, kEndless), Qt::TextWordWrap, text)
      .height();
}

/// Paints a study as a card.
class StudyCard final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const auto lines = index.data(kLinesRole).toStringList();
    const auto& font = option.widget->font();
    const int width = option.rect.width() - 2 * kPaddingX;
    int height = kGapBetweenRows + 2 * kPaddingY;
    for (int i = 0; i < lines.size(); ++i) {
      if (i > 0) height += kGapBetweenLines;
      height += heightOfText(i == 0 ? boldOf(font) : font, width, lines[i]);
    }
    if (index.data(StudyList::kShareRole).isValid()) height += kAboveBar + kBarHeight;
    return {option.rect.width(), height};
  }

  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index)
      const override {
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    const QRect card = option.rect.adjusted(1, 1, -1, -kGapBetweenRows);
    paintCard(*painter, card, option);
    QRect room = card.adjusted(kPaddingX - 1, kPaddingY, -kPaddingX + 1, -kPaddingY);
    paintLines(*painter, room, *option.widget, index);
    paintBar(*painter, room, *option.widget, index.data(StudyList::kShareRole));
    painter->restore();
  }

 private:
  /// The frame is thicker around the chosen study while the list has the focus.
  static void paintCard(QPainter& painter, const QRect& card, const QStyleOptionViewItem& option) {
    constexpr double kTint = 0.13;
    constexpr double kThick = 3.0;
    constexpr int kMark = 5;
    const auto& colours = themeOf(*option.widget);
    const bool isChosen = option.state.testFlag(QStyle::State_Selected);
    const bool isFocused = isChosen && option.widget->hasFocus();
    const auto& field = colours.field.background;
    painter.setPen(
        isFocused ? QPen(colours.focus, kThick)
                  : QPen(isChosen ? colours.accent.background : colours.line, 1.0));
    painter.setBrush(isChosen ? mixed(field, colours.accent.background, kTint) : field);
    const double inside = isFocused ? 0.5 * kThick : 0.5;
    painter.drawRoundedRect(
        QRectF(card).adjusted(inside, inside, -inside, -inside), kCorner, kCorner);
    if (!isChosen) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.accent.background);
    const QRectF mark(
        card.left() + kMark, card.top() + kPaddingY, kMark, card.height() - 2 * kPaddingY);
    painter.drawRoundedRect(mark, 0.5 * kMark, 0.5 * kMark);
  }

  /// Leaves the room below the text in @p room.
  static void paintLines(
      QPainter& painter, QRect& room, const QWidget& widget, const QModelIndex& index) {
    const auto& colours = themeOf(widget);
    const auto lines = index.data(kLinesRole).toStringList();
    const bool isBroken = index.data(kBrokenRole).toBool();
    const std::array<QColor, 3> inks{
        colours.field.text, colours.quiet, isBroken ? colours.bad.background : colours.field.text};
    std::size_t line = 0;
    for (const auto& text : lines) {
      painter.setFont(line == 0 ? boldOf(widget.font()) : widget.font());
      painter.setPen(inks.at(line++));
      QRect used;
      painter.drawText(room, Qt::TextWordWrap | Qt::AlignLeft | Qt::AlignTop, text, &used);
      room.setTop(used.bottom() + 1 + kGapBetweenLines);
    }
  }

  static void paintBar(
      QPainter& painter, const QRect& room, const QWidget& widget, const QVariant& share) {
    if (!share.isValid()) return;
    const auto& colours = themeOf(widget);
    constexpr double kRound = 0.5 * kBarHeight;
    QRectF track(room.left(), room.bottom() + 1 - kBarHeight, room.width(), kBarHeight);
    painter.setPen(Qt::NoPen);
    painter.setBrush(colours.line);
    painter.drawRoundedRect(track, kRound, kRound);
    if (share.toDouble() <= 0.0) return;
    track.setWidth(std::max<double>(kBarHeight, share.toDouble() * track.width()));
    painter.setBrush(colours.accent.background);
    painter.drawRoundedRect(track, kRound, kRound);
  }
};

}  // namespace

StudyList::StudyList(QWidget* parent) : QTableWidget(0, 1, parent) {
  makeReadOnly(*this);
  setItemDelegate(new StudyCard(this));
  setProperty("role", QStringLiteral("cards"));
  setSelectionBehavior(QAbstractItemView::SelectRows);
  setSelectionMode(QAbstractItemView::SingleSelection);
  setWordWrap(true);
  setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
  horizontalHeader()->hide();
  horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
}

void StudyList::setRow(int row, const Row& shown) {
  const QStringList lines{shown.title, shown.place, shown.progress};
  auto* cell = new QTableWidgetItem(lines.join(QLatin1Char('\n')));
  cell->setData(kLinesRole, lines);
  cell->setData(kBrokenRole, shown.isBroken);
  if (shown.share) cell->setData(kShareRole, *shown.share);
  setItem(row, 0, cell);
}

int StudyList::heightOfRows() const {
  return verticalHeader()->length() + 2 * frameWidth();
}

QSize StudyList::sizeHint() const {
  constexpr int kUsual = 340;  // [px]; a longer list is scrolled
  return {minimumSizeHint().width(), std::min(kUsual, heightOfRows())};
}

QSize StudyList::minimumSizeHint() const {
  constexpr QSize kLeast(240, 150);  // [px]
  return {kLeast.width(), std::min(kLeast.height(), heightOfRows())};
}

/// Qt calls this when the heights of the rows or their number have changed.
void StudyList::updateGeometries() {
  QTableWidget::updateGeometries();
  const int most = std::max(1, heightOfRows());
  if (most == maximumHeight()) return;
  setMaximumHeight(most);
  updateGeometry();
}

void StudyList::resizeEvent(QResizeEvent* event) {
  QTableWidget::resizeEvent(event);
  // Titles wrap at another width.
  QTimer::singleShot(0, this, &QTableWidget::resizeRowsToContents);
}

}  // namespace study::gui
