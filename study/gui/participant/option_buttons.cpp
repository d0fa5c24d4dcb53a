#include "study/gui/participant/option_buttons.h"

#include <algorithm>

#include <QGridLayout>
#include <QKeyEvent>
#include <QPainter>
#include <QVariant>

#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

/// Qt does not wrap the words of a button.
QString inLines(QString text) {
  constexpr qsizetype kLine = 54;  // [characters] that fit into the column of a small window
  for (qsizetype start = 0; text.size() - start > kLine;) {
    const auto space = text.lastIndexOf(QLatin1Char(' '), start + kLine);
    if (space <= start) break;
    text[space] = QLatin1Char('\n');
    start = space + 1;
  }
  return text;
}

/// A button with a ring, so that it is seen as one of several to choose from: beside the words of
/// an option, below the number of a point.
class RingButton final : public QPushButton {
 public:
  using QPushButton::QPushButton;

 protected:
  void paintEvent(QPaintEvent* event) override {
    QPushButton::paintEvent(event);
    constexpr int kAtSide = 22;  // [px] at scale 1, from the edge to the centre
    constexpr int kAtBottom = 13;
    constexpr int kRadius = 9;
    constexpr int kSmallRadius = 6;
    const bool isOption = property("role").toString() == QStringLiteral("option");
    const int r = scaled(*this, isOption ? kRadius : kSmallRadius);
    const bool isMirrored = layoutDirection() == Qt::RightToLeft;
    const int side = isMirrored ? width() - scaled(*this, kAtSide) : scaled(*this, kAtSide);
    const int below = text().isEmpty() ? height() / 2 : height() - scaled(*this, kAtBottom);
    const QPointF centre = isOption ? QPointF(side, 0.5 * height()) : QPointF(0.5 * width(), below);
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
};

}  // namespace

OptionButtons::OptionButtons(
    const std::vector<Option>& options, int columns, const QString& role, QWidget* parent)
    : QWidget(parent), group_(new QButtonGroup(this)), columns_(columns) {
  auto* layout = new QGridLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(scaled(*this, 8));
  for (int column = 0; column < columns_; ++column) layout->setColumnStretch(column, 1);
  for (const auto& option : options) {
    auto* button = new RingButton(inLines(option.text), this);
    button->setCheckable(true);
    button->setProperty("role", role);
    button->setProperty("isMirrored", layoutDirection() == Qt::RightToLeft);
    button->setAccessibleName(option.accessibleName);
    button->installEventFilter(this);
    const int place = static_cast<int>(buttons_.size());
    group_->addButton(button, place);
    buttons_.push_back(button);
    layout->addWidget(button, place / columns_, place % columns_);
  }
  if (!buttons_.empty()) setFocusProxy(buttons_.front());
  connect(group_, &QButtonGroup::idToggled, this, [this](int id, bool isChecked) {
    if (isChecked) emit chosenChanged(id);
  });
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

int columnsFor(const std::vector<OptionButtons::Option>& options) {
  // [characters] that fit into a button beside others of its kind, in the participant's column
  constexpr qsizetype kInTwo = 25;
  constexpr qsizetype kInThree = 14;
  constexpr qsizetype kInFour = 9;
  qsizetype longest = 0;
  for (const auto& option : options) longest = std::max(longest, option.text.size());
  const int count = static_cast<int>(options.size());
  const int most = longest <= kInFour ? 4 : longest <= kInThree ? 3 : longest <= kInTwo ? 2 : 1;
  // Four in two rows of two look better than three and one.
  return count == 4 && most == 3 ? 2 : std::min(count, most);
}

}  // namespace study::gui
