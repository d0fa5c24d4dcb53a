#include "study/gui/participant/option_buttons.h"

#include <algorithm>

#include <QKeyEvent>
#include <QPainter>
#include <QPolygonF>
#include <QVariant>

#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

/// Qt does not wrap the words of a button.
QString brokenIntoLines(QString text) {
  constexpr qsizetype kLineLength = 54;  // [characters] that fit into the column of a small window
  for (qsizetype start = 0; text.size() - start > kLineLength;) {
    const auto space = text.lastIndexOf(QLatin1Char(' '), start + kLineLength);
    if (space <= start) break;
    text[space] = QLatin1Char('\n');
    start = space + 1;
  }
  return text;
}

/// A button that is seen as one of several to choose from: with a ring beside the words of an
/// option, or in a point without a number. A number stands for itself, and has a check mark once it
/// is chosen.
class RingButton final : public QPushButton {
 public:
  using QPushButton::QPushButton;

 protected:
  void paintEvent(QPaintEvent* event) override {
    QPushButton::paintEvent(event);
    const bool isOption = property("role").toString() == QStringLiteral("option");
    if (isOption || text().isEmpty()) {
      paintRing(isOption);
    } else if (isChecked()) {
      paintCheckMark();
    }
  }

 private:
  void paintRing(bool isAtSide) {
    constexpr int kEdgeToCentre = 22;  // [px] at scale 1, from the edge to the centre
    constexpr int kRingRadius = 9;
    const int r = scaled(*this, kRingRadius);
    const bool isMirrored = layoutDirection() == Qt::RightToLeft;
    const int side =
        isMirrored ? width() - scaled(*this, kEdgeToCentre) : scaled(*this, kEdgeToCentre);
    const QPointF centre(isAtSide ? side : 0.5 * width(), 0.5 * height());
    const auto& theme = themeOf(*this);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(QPen(isChecked() ? theme.accent.text : theme.border, 0.22 * r));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, r, r);
    if (!isChecked()) return;
    painter.setPen(Qt::NoPen);
    painter.setBrush(theme.accent.text);
    painter.drawEllipse(centre, 0.55 * r, 0.55 * r);
  }

  void paintCheckMark() {
    constexpr int kSize = 11;  // [px] at scale 1
    constexpr int kBesideNumber = 16;
    const double size = scaled(*this, kSize);
    const QPointF place(0.5 * width() + scaled(*this, kBesideNumber), 0.5 * (height() - size));
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    QPen pen(themeOf(*this).accent.text, 0.2 * size);
    pen.setCapStyle(Qt::RoundCap);
    pen.setJoinStyle(Qt::RoundJoin);
    painter.setPen(pen);
    painter.drawPolyline(QPolygonF{
        place + QPointF(0.0, 0.55 * size),
        place + QPointF(0.35 * size, 0.9 * size),
        place + QPointF(size, 0.1 * size)});
  }
};

}  // namespace

OptionButtons::OptionButtons(
    const std::vector<Option>& options, int columns, const QString& role, QWidget* parent)
    : QWidget(parent),
      group_(new QButtonGroup(this)),
      grid_(new QGridLayout(this)),
      isFlexible_(columns == kAsManyAsFit) {
  setProperty("role", QStringLiteral("plain"));
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setSpacing(scaled(*this, 8));
  for (const auto& option : options) {
    auto* button = new RingButton(brokenIntoLines(option.text), this);
    button->setCheckable(true);
    button->setProperty("role", role);
    button->setProperty("isMirrored", layoutDirection() == Qt::RightToLeft);
    button->setAccessibleName(option.accessibleName);
    button->installEventFilter(this);
    group_->addButton(button, static_cast<int>(buttons_.size()));
    buttons_.push_back(button);
  }
  fill(isFlexible_ ? 1 : columns);
  if (!buttons_.empty()) setFocusProxy(buttons_.front());
  connect(group_, &QButtonGroup::idToggled, this, [this](int id, bool isChecked) {
    if (isChecked) emit chosenChanged(id);
  });
}

void OptionButtons::makeLarge() {
  for (auto* button : buttons_) button->setProperty("isLarge", true);
}

int OptionButtons::widestButton() const {
  int width = 0;
  for (auto* button : buttons_) {
    button->ensurePolished();
    width = std::max(width, button->sizeHint().width());
  }
  return width;
}

/// The number of columns that fit into @p width, so that the last row is about as long as the
/// others: four options in two rows of two rather than three and one.
int OptionButtons::columnsAt(int width) const {
  const int count = static_cast<int>(buttons_.size());
  const int between = grid_->spacing();
  const int most = std::clamp((width + between) / std::max(1, widestButton() + between), 1, count);
  const int rows = (count + most - 1) / most;
  return (count + rows - 1) / rows;
}

void OptionButtons::fill(int columns) {
  for (auto* button : buttons_) grid_->removeWidget(button);
  for (int i = 0; i < std::max(columns, columns_); ++i) {
    grid_->setColumnStretch(i, i < columns ? 1 : 0);
  }
  columns_ = columns;
  for (int place = 0; place < static_cast<int>(buttons_.size()); ++place) {
    grid_->addWidget(button(place), place / columns_, place % columns_);
  }
}

/// As wide as one column, so that a window can be made narrower again.
QSize OptionButtons::minimumSizeHint() const {
  const QSize least = QWidget::minimumSizeHint();
  return isFlexible_ ? QSize(std::min(widestButton(), least.width()), least.height()) : least;
}

void OptionButtons::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  if (!isFlexible_ || buttons_.empty()) return;
  const int columns = columnsAt(width());
  if (columns == columns_) return;
  fill(columns);
  grid_->activate();  // at once, before anything is painted
}

void OptionButtons::choose(int index) {
  if (index >= 0 && index < static_cast<int>(buttons_.size())) button(index)->setChecked(true);
}

bool OptionButtons::moveFocus(int from, int key) {
  const bool isForward = key == Qt::Key_Right || key == Qt::Key_Down;
  const bool isBackward = key == Qt::Key_Left || key == Qt::Key_Up;
  if (!isForward && !isBackward) return false;
  const bool isMirrored =
      layoutDirection() == Qt::RightToLeft && (key == Qt::Key_Left || key == Qt::Key_Right);
  const bool isRow = key == Qt::Key_Up || key == Qt::Key_Down;
  const bool hasRows = columns_ < static_cast<int>(buttons_.size());
  const int step = isRow && hasRows ? columns_ : 1;
  const int to = from + (isForward != isMirrored ? step : -step);
  if (to < 0 || to >= static_cast<int>(buttons_.size())) return true;
  button(to)->setFocus(Qt::TabFocusReason);
  return true;
}

bool OptionButtons::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() != QEvent::KeyPress) return QWidget::eventFilter(watched, event);
  const auto* key = static_cast<QKeyEvent*>(event);
  const auto found = std::find(buttons_.begin(), buttons_.end(), watched);
  if (found == buttons_.end()) return false;
  if (moveFocus(static_cast<int>(found - buttons_.begin()), key->key())) return true;
  if (key->key() == Qt::Key_Return || key->key() == Qt::Key_Enter) {
    (*found)->click();
    return true;
  }
  // A digit chooses the option with that text, or else at that position.
  const QString digit = key->text();
  for (auto* candidate : buttons_) {
    if (!digit.isEmpty() && candidate->text() == digit) {
      candidate->setFocus(Qt::TabFocusReason);
      candidate->click();
      return true;
    }
  }
  bool isNumber = false;
  const int place = digit.toInt(&isNumber);
  const bool bearsNumbers =
      buttons_.front()->text().left(1).toInt() > 0 || buttons_.front()->text().startsWith(u'0');
  if (!isNumber || bearsNumbers || place < 1 || place > static_cast<int>(buttons_.size()))
    return false;
  button(place - 1)->setFocus(Qt::TabFocusReason);
  button(place - 1)->click();
  return true;
}

}  // namespace study::gui
