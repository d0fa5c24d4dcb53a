#include "study/gui/participant/option_buttons.h"

#include <algorithm>

#include <QBoxLayout>
#include <QKeyEvent>
#include <QVariant>

namespace study::gui {

OptionButtons::OptionButtons(
    const std::vector<Option>& options,
    Qt::Orientation orientation,
    const QString& role,
    QWidget* parent)
    : QWidget(parent), group_(new QButtonGroup(this)) {
  auto* layout = new QBoxLayout(
      orientation == Qt::Horizontal ? QBoxLayout::LeftToRight : QBoxLayout::TopToBottom, this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(orientation == Qt::Horizontal ? 12 : 8);
  for (const auto& option : options) {
    auto* button = new QPushButton(option.text, this);
    button->setCheckable(true);
    button->setProperty("role", role);
    button->setAccessibleName(option.accessibleName);
    button->installEventFilter(this);
    group_->addButton(button, static_cast<int>(buttons_.size()));
    buttons_.push_back(button);
    layout->addWidget(button);
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
  const int to = from + (isForward != isMirrored ? 1 : -1);
  button(std::clamp(to, 0, static_cast<int>(buttons_.size()) - 1))->setFocus(Qt::TabFocusReason);
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
  const bool bearsNumbers = buttons_.front()->text().at(0).isDigit();
  if (!isNumber || bearsNumbers || place < 1 || place > static_cast<int>(buttons_.size()))
    return false;
  button(place - 1)->setFocus(Qt::TabFocusReason);
  button(place - 1)->click();
  return true;
}

}  // namespace study::gui
