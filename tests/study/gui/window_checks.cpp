#include "tests/study/gui/window_checks.h"

#include <algorithm>
#include <map>
#include <set>
#include <vector>

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAbstractSpinBox>
#include <QAccessible>
#include <QApplication>
#include <QButtonGroup>
#include <QCheckBox>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScrollArea>
#include <QScrollBar>
#include <QStyleOptionComboBox>
#include <QTabBar>
#include <QTableView>
#include <QTest>
#include <QTextBrowser>

#include "study/gui/participant/participant_window.h"
#include "study/gui/participant/questionnaire_page.h"
#include "study/gui/participant/trial_page.h"
#include "study/gui/widgets/mnemonics.h"
#include "study/gui/widgets/theme.h"
#include "tests/study/gui/contrast.h"

namespace tests {
namespace {

QString textOf(const QWidget& widget) {
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->text();
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) return button->text();
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) return box->currentText();
  if (const auto* line = qobject_cast<const QLineEdit*>(&widget)) return line->text();
  return {};
}

QString nameOf(const QWidget& widget) {
  const QString text = textOf(widget).left(40);
  const QString name = text.isEmpty() ? widget.accessibleName() : text;
  return QStringLiteral("%1 '%2'").arg(
      QString::fromUtf8(widget.metaObject()->className()),
      name.isEmpty() ? widget.objectName() : name);
}

/// Whether @p widget belongs to a control of Qt's own, which paints or labels it.
bool isInner(const QWidget& widget) {
  for (const auto* up = widget.parentWidget(); up != nullptr; up = up->parentWidget()) {
    const bool isControl = qobject_cast<const QAbstractSpinBox*>(up) != nullptr ||
                           qobject_cast<const QComboBox*>(up) != nullptr ||
                           qobject_cast<const QAbstractItemView*>(up) != nullptr ||
                           qobject_cast<const QTabBar*>(up) != nullptr ||
                           qobject_cast<const QMenuBar*>(up) != nullptr ||
                           qobject_cast<const QLineEdit*>(up) != nullptr;
    if (isControl) return true;
    if (up->isWindow()) return false;
  }
  return false;
}

std::vector<QWidget*> visibleIn(QWidget& window) {
  std::vector<QWidget*> found;
  for (auto* widget : window.findChildren<QWidget*>()) {
    if (widget->isVisible() && widget->window() == &window) found.push_back(widget);
  }
  return found;
}

QList<QRect> placesOfAll() {
  QList<QRect> places;
  for (const auto* widget : QApplication::allWidgets()) {
    if (widget->isVisible()) places << widget->geometry();
  }
  return places;
}

/// Waits until nothing moves any more: a layout that changes its direction, or a text that is
/// wrapped, asks those around it for other sizes, round after round.
void settle() {
  constexpr int kLeastRounds = 6;
  constexpr int kMostRounds = 50;
  auto before = placesOfAll();
  for (int round = 1; round <= kMostRounds; ++round) {
    QApplication::processEvents();
    QApplication::sendPostedEvents(nullptr, QEvent::LayoutRequest);
    auto now = placesOfAll();
    if (round >= kLeastRounds && now == before) return;
    before = std::move(now);
  }
}

/// The part of @p widget that its words are painted in: without its frame, so that only glyphs are
/// measured.
QRect placeOfWords(const QWidget& widget) {
  constexpr QMargins kFrame(8, 5, 8, 5);  // [px]: border and round corners
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
    QStyleOptionComboBox option;
    option.initFrom(box);
    option.editable = box->isEditable();
    return box->style()
        ->subControlRect(QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box)
        .adjusted(2, 2, -2, -2);
  }
  if (qobject_cast<const QCheckBox*>(&widget) != nullptr) {
    QStyleOptionButton option;
    option.initFrom(&widget);
    return widget.style()->subElementRect(QStyle::SE_CheckBoxContents, &option, &widget);
  }
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) return label->contentsRect();
  return widget.rect().marginsRemoved(kFrame);
}

/// Judges whether the glyphs of @p text can be read in @p picture: whether enough of its pixels
/// have the contrast @p least with the colour that most pixels have.
void judge(
    const QImage& picture,
    const QString& what,
    const QString& text,
    double least,
    QStringList& found) {
  constexpr auto kPixelsOfALetter = 2;  // at least; a small "i" has ten
  constexpr auto kMostLetters = 12;     // the others may be cut off
  const auto counts = study::gui::coloursOf(picture);
  if (counts.empty()) return;
  const auto ground = std::max_element(
      counts.begin(), counts.end(), [](auto& a, auto& b) { return a.second < b.second; });
  double most = 1.0;
  std::ptrdiff_t legible = 0;
  for (const auto& [colour, count] : counts) {
    const double contrast = study::gui::contrast(QColor(colour), QColor(ground->first));
    most = std::max(most, contrast);
    if (contrast >= least) legible += count;
  }
  const auto letters =
      std::count_if(text.begin(), text.end(), [](QChar c) { return c.isLetterOrNumber(); });
  if (legible >= kPixelsOfALetter * std::clamp<std::ptrdiff_t>(letters, 1, kMostLetters)) return;
  found << QStringLiteral("%1: contrast %2 in %3 pixels")
               .arg(what)
               .arg(most, 0, 'f', 2)
               .arg(static_cast<qlonglong>(legible));
}

void judgeEntries(QComboBox& box, double least, QStringList& found) {
  box.showPopup();
  settle();
  auto* list = box.view();
  const int before = box.currentIndex();
  for (int row = 0; row < box.count(); ++row) {
    const auto index = list->model()->index(row, box.modelColumn(), list->rootIndex());
    if (index.data().toString().trimmed().isEmpty()) continue;
    list->setCurrentIndex(index);
    list->scrollTo(index);
    const auto place = list->visualRect(index).adjusted(4, 4, -4, -4);
    const auto shown = list->viewport()->grab().toImage();
    judge(
        shown.copy(place),
        nameOf(box) + QStringLiteral(", entry ") + index.data().toString(),
        index.data().toString(),
        least,
        found);
  }
  box.hidePopup();
  settle();
  if (box.currentIndex() != before) found << nameOf(box) + QStringLiteral(": looking has chosen");
}

void judgeMenu(QMenu& menu, double least, QStringList& found) {
  menu.popup(QPoint(0, 0));
  settle();
  for (auto* action : menu.actions()) {
    if (action->isSeparator() || action->menu() != nullptr) continue;
    menu.setActiveAction(action);
    const auto shown = menu.grab().toImage();
    judge(
        shown.copy(menu.actionGeometry(action).adjusted(4, 2, -4, -2)),
        QStringLiteral("menu entry ") + action->text(),
        action->text(),
        least,
        found);
  }
  menu.hide();
  settle();
  for (auto* action : menu.actions()) {
    if (action->menu() != nullptr) judgeMenu(*action->menu(), least, found);
  }
}

/// The scroll area that @p widget can be scrolled in; nullptr if there is none.
QScrollArea* scrollAreaOf(const QWidget& widget) {
  for (auto* up = widget.parentWidget(); up != nullptr && !up->isWindow();
       up = up->parentWidget()) {
    auto* area = qobject_cast<QScrollArea*>(up);
    if (area != nullptr && area->widget() != nullptr && area->widget()->isAncestorOf(&widget)) {
      return area;
    }
  }
  return nullptr;
}

/// Whether @p widget can be seen completely, if need be after scrolling up or down.
bool isInSight(const QWidget& widget) {
  const auto* area = scrollAreaOf(widget);
  if (area == nullptr) return widget.visibleRegion().boundingRect() == widget.rect();
  const QRect place(widget.mapTo(area->widget(), QPoint(0, 0)), widget.size());
  const bool fitsAcross = place.left() >= 0 && place.right() < area->viewport()->width();
  return fitsAcross && area->widget()->rect().contains(place) &&
         area->viewport()->height() >= std::min(widget.height(), 30);
}

bool hasRoomForItsWords(const QWidget& widget) {
  constexpr int kRounding = 2;  // [px]
  if (const auto* label = qobject_cast<const QLabel*>(&widget)) {
    if (label->text().isEmpty()) return true;
    if (!label->wordWrap()) return label->sizeHint().width() <= label->width() + kRounding;
    return label->heightForWidth(label->width()) <= label->height();
  }
  if (const auto* button = qobject_cast<const QAbstractButton*>(&widget)) {
    return button->text().isEmpty() || button->sizeHint().width() <= button->width() + kRounding;
  }
  if (const auto* box = qobject_cast<const QComboBox*>(&widget)) {
    QStyleOptionComboBox option;
    option.initFrom(box);
    option.editable = box->isEditable();
    const auto place = box->style()->subControlRect(
        QStyle::CC_ComboBox, &option, QStyle::SC_ComboBoxEditField, box);
    int needed = 0;  // of any entry, because each can be chosen
    for (int i = 0; i < box->count(); ++i) {
      needed = std::max(needed, box->fontMetrics().horizontalAdvance(box->itemText(i)));
    }
    return needed <= place.width() + kRounding &&
           box->fontMetrics().height() <= place.height() + kRounding;
  }
  return true;
}

/// The cells of a table in sight whose words are cut off.
QStringList cutOffCells(const QTableView& table) {
  constexpr int kCellPadding = 12;  // [px] of a cell, left and right of its words
  constexpr int kRounding = 3;
  QStringList found;
  const auto* model = table.model();
  for (int row = 0; model != nullptr && row < model->rowCount(); ++row) {
    for (int column = 0; column < model->columnCount(); ++column) {
      const auto index = model->index(row, column);
      const QRect place = table.visualRect(index);
      const auto words = index.data().toString();
      if (place.isEmpty() || words.isEmpty() || table.isColumnHidden(column)) continue;
      const auto own = index.data(Qt::FontRole);
      const QFontMetrics metrics(own.isValid() ? own.value<QFont>() : table.font());
      const int room = place.width() - kCellPadding + kRounding;
      const auto needed = metrics.boundingRect(
          QRect(0, 0, table.wordWrap() ? room : QWIDGETSIZE_MAX, QWIDGETSIZE_MAX),
          table.wordWrap() ? Qt::TextWordWrap : 0,
          words);
      if (needed.width() > room || needed.height() > place.height() + kRounding) found << words;
    }
  }
  return found;
}

QRect placeOf(const QWidget* widget) {
  return {widget->mapTo(widget->window(), QPoint(0, 0)), widget->size()};
}

/// Whether the name of a field is level with its middle, if it is beside a field of one line.
bool isLevelWithItsField(const QLabel& label) {
  constexpr int kRounding = 2;  // [px]
  constexpr int kMostLines = 3;
  const auto* field = label.buddy();
  if (field == nullptr || field->height() > kMostLines * label.fontMetrics().height()) return true;
  const QRect own = placeOf(&label);
  const QRect other = placeOf(field);
  const bool isBeside = own.top() <= other.bottom() && other.top() <= own.bottom();
  return !isBeside || std::abs(own.center().y() - other.center().y()) <= kRounding;
}

bool isControlOrText(const QWidget& widget) {
  return qobject_cast<const QLabel*>(&widget) != nullptr ||
         qobject_cast<const QAbstractButton*>(&widget) != nullptr ||
         qobject_cast<const QComboBox*>(&widget) != nullptr ||
         qobject_cast<const QLineEdit*>(&widget) != nullptr ||
         qobject_cast<const QPlainTextEdit*>(&widget) != nullptr ||
         qobject_cast<const QAbstractSpinBox*>(&widget) != nullptr;
}

/// The stops from @p first on, as @p key visits them; the last one is @p first again, unless more
/// than all widgets were visited.
std::vector<QWidget*> stopsFrom(QWidget& first, int key, std::size_t most) {
  std::vector<QWidget*> stops{&first};
  while (stops.size() <= most) {
    QTest::keyClick(stops.back(), static_cast<Qt::Key>(key));
    auto* focus = QApplication::focusWidget();
    if (focus == nullptr) break;
    stops.push_back(focus);
    if (focus == &first) break;
  }
  return stops;
}

bool isExpectedStop(const QWidget& widget) {
  const bool takesTab = (widget.focusPolicy() & Qt::TabFocus) == Qt::TabFocus;
  return takesTab && widget.isEnabled() && widget.focusProxy() == nullptr;
}

/// Whether a widget holds other controls and texts: a page that is scrolled, or that is itself the
/// handle of a virtual instrument.
bool isPage(const QWidget& widget) {
  return qobject_cast<const QScrollArea*>(&widget) != nullptr ||
         widget.findChild<QLabel*>() != nullptr;
}

/// Whether the focus can be seen: whether enough pixels change by the contrast 3 (WCAG 2.4.13).
bool looksFocused(QWidget& stop) {
  constexpr double kLeast = 3.0;
  constexpr int kLeastPixels = 12;  // a text cursor
  stop.setFocus(Qt::TabFocusReason);
  settle();
  const auto with = stop.grab().toImage();
  stop.clearFocus();
  settle();
  const auto without = stop.grab().toImage();
  if (with.size() != without.size()) return true;
  int changed = 0;
  for (int y = 0; y < with.height(); ++y) {
    for (int x = 0; x < with.width(); ++x) {
      const QRgb a = with.pixel(x, y);
      const QRgb b = without.pixel(x, y);
      if (a != b && study::gui::contrast(QColor(a), QColor(b)) >= kLeast) ++changed;
    }
  }
  return changed >= kLeastPixels;
}

/// Whether arrow keys lead to @p widget from one of @p stops: options that exclude each other are
/// one stop.
bool isInGroupOf(const QWidget& widget, const std::vector<QWidget*>& stops) {
  const auto* button = qobject_cast<const QAbstractButton*>(&widget);
  if (button == nullptr || button->group() == nullptr) return false;
  return std::any_of(stops.begin(), stops.end(), [&](const QWidget* stop) {
    const auto* other = qobject_cast<const QAbstractButton*>(stop);
    return other != nullptr && other->group() == button->group();
  });
}

/// Participants have no use for mnemonics.
std::vector<const QWidget*> pagesForParticipants(QWidget& window) {
  using namespace study::gui;
  std::vector<const QWidget*> pages;
  if (qobject_cast<ParticipantWindow*>(&window) != nullptr) pages.push_back(&window);
  for (auto* page : window.findChildren<ParticipantWindow*>()) pages.push_back(page);
  for (auto* page : window.findChildren<QuestionnairePage*>()) pages.push_back(page);
  for (auto* page : window.findChildren<TrialPage*>()) pages.push_back(page);
  return pages;
}

}  // namespace

QStringList unreadableTexts(QWidget& window, double least) {
  QStringList found;
  settle();
  for (auto* widget : visibleIn(window)) {
    if (textOf(*widget).trimmed().isEmpty() || isInner(*widget)) continue;
    if (widget->visibleRegion().isEmpty()) continue;
    // With what is behind it, as far as it is in sight.
    QRect seen = widget->visibleRegion().boundingRect() & placeOfWords(*widget);
    seen.moveTopLeft(widget->mapTo(&window, seen.topLeft()));
    if (seen.height() >= widget->fontMetrics().height()) {
      judge(window.grab(seen).toImage(), nameOf(*widget), textOf(*widget), least, found);
    }
    auto* box = qobject_cast<QComboBox*>(widget);
    if (box != nullptr && box->isEnabled()) judgeEntries(*box, least, found);
  }
  for (auto* menu : window.findChildren<QMenuBar*>()) {
    for (auto* action : menu->actions()) {
      if (action->menu() != nullptr) judgeMenu(*action->menu(), least, found);
    }
  }
  return found;
}

QStringList cutOffAt(QWidget& window, QSize size) {
  QStringList found;
  window.resize(size);
  settle();
  const auto about = [&](const QString& what) {
    found << QStringLiteral("%1×%2: %3").arg(size.width()).arg(size.height()).arg(what);
  };
  if (window.width() > size.width() || window.height() > size.height()) {
    about(QStringLiteral("needs %1×%2").arg(window.width()).arg(window.height()));
    return found;
  }
  const auto previews = window.findChildren<study::gui::ParticipantWindow*>();
  for (auto* widget : visibleIn(window)) {
    // A preview has the size of the participant's screen and is scrolled.
    const bool isInPreview = std::any_of(
        previews.begin(), previews.end(), [&](auto* page) { return page->isAncestorOf(widget); });
    if (isInPreview || !isControlOrText(*widget) || isInner(*widget)) continue;
    const auto* label = qobject_cast<const QLabel*>(widget);
    if (label != nullptr && label->text().isEmpty()) continue;
    if (label != nullptr && !isLevelWithItsField(*label)) {
      about(nameOf(*label) + QStringLiteral(" is not level with its field"));
    }
    if (!isInSight(*widget)) about(nameOf(*widget) + QStringLiteral(" is not in sight"));
    if (!hasRoomForItsWords(*widget))
      about(nameOf(*widget) + QStringLiteral(" has no room for its words"));
  }
  constexpr int kRoomForTables = 1024;  // [px]; narrower ones are scrolled or leave words out
  for (const auto* table : window.findChildren<QTableView*>()) {
    if (size.width() < kRoomForTables || !table->isVisible()) continue;
    for (const auto& words : cutOffCells(*table)) {
      about(nameOf(*table) + QStringLiteral(" cuts off '") + words + QLatin1Char('\''));
    }
  }
  return found;
}

QStringList lostFocus(QWidget& window) {
  QStringList found;
  std::set<QWidget*> expected;
  for (auto* widget : visibleIn(window)) {
    if (isExpectedStop(*widget) && !isInner(*widget)) expected.insert(widget);
  }
  if (expected.empty()) return found;
  window.activateWindow();
  settle();
  if (QApplication::focusWidget() == nullptr) (*expected.begin())->setFocus();
  // The first Tab may lead from a widget that is no stop itself.
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  auto* first = QApplication::focusWidget();
  if (first == nullptr) return {QStringLiteral("Tab loses the focus")};
  const std::size_t most = 2 * window.findChildren<QWidget*>().size();
  auto forward = stopsFrom(*first, Qt::Key_Tab, most);
  if (forward.back() != first)
    found << QStringLiteral("Tab is caught at ") + nameOf(*forward.back());
  for (auto* stop : forward) expected.erase(stop);
  for (auto* stop : expected) {
    if (isInGroupOf(*stop, forward)) continue;
    found << QStringLiteral("Tab does not reach ") + nameOf(*stop);
  }
  const auto backward = stopsFrom(*first, Qt::Key_Backtab, most);
  std::reverse(forward.begin(), forward.end());
  if (forward != backward) found << QStringLiteral("Shift+Tab does not go back the same way");
  for (auto* stop : std::set<QWidget*>(forward.begin(), forward.end())) {
    if (!isPage(*stop) && !looksFocused(*stop))
      found << nameOf(*stop) + QStringLiteral(" does not show the focus");
  }
  return found;
}

namespace {

void collectUnnamed(QAccessibleInterface* node, QStringList& found) {
  if (node == nullptr || !node->isValid() || node->state().invisible) return;
  if (node->state().focusable && node->text(QAccessible::Name).trimmed().isEmpty()) {
    const auto* widget = qobject_cast<QWidget*>(node->object());
    if (widget != nullptr && !isInner(*widget) && widget->focusProxy() == nullptr) {
      found << nameOf(*widget) + QStringLiteral(" has no name for a screen reader");
    }
  }
  // Cells are named by their contents.
  if (node->tableInterface() != nullptr) return;
  for (int i = 0; i < node->childCount(); ++i) collectUnnamed(node->child(i), found);
}

}  // namespace

QStringList unnamedElements(QWidget& window) {
  QStringList found;
  collectUnnamed(QAccessible::queryAccessibleInterface(&window), found);
  return found;
}

namespace {

void checkMenu(QMenu& menu, QStringList& found) {
  study::gui::addMnemonics(menu);
  std::map<QChar, QString> taken;
  for (auto* action : menu.actions()) {
    if (action->isSeparator()) continue;
    const auto letter = study::gui::mnemonicOf(action->text());
    if (letter.isNull()) found << QStringLiteral("menu entry ") + action->text();
    if (!letter.isNull() && !taken.emplace(letter, action->text()).second) {
      found << QStringLiteral("%1 and %2 share a letter").arg(action->text(), taken[letter]);
    }
    if (action->menu() != nullptr) checkMenu(*action->menu(), found);
  }
}

}  // namespace

QStringList textsWithoutMnemonic(QWidget& window) {
  QStringList found;
  std::map<QChar, std::set<QString>> sharers;
  const auto check = [&](const QString& text, const QWidget& of) {
    if (text.isEmpty()) return;
    const auto letter = study::gui::mnemonicOf(text);
    const auto plain = QString(text).remove(u'&');
    if (letter.isNull()) found << nameOf(of) + QStringLiteral(" has no mnemonic");
    if (!letter.isNull()) sharers[letter].insert(plain);
  };
  const auto pages = pagesForParticipants(window);
  for (auto* widget : window.findChildren<QWidget*>()) {
    const bool isElsewhere = widget->window() != &window ||
                             std::any_of(pages.begin(), pages.end(), [&](const QWidget* page) {
                               return page == widget || page->isAncestorOf(widget);
                             });
    if (isElsewhere || isInner(*widget)) continue;
    if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
      check(button->text(), *widget);
    } else if (const auto* label = qobject_cast<const QLabel*>(widget)) {
      if (label->buddy() != nullptr) check(label->text(), *widget);
    } else if (const auto* tabs = qobject_cast<const QTabBar*>(widget)) {
      for (int tab = 0; tab < tabs->count(); ++tab) check(tabs->tabText(tab), *widget);
    } else if (const auto* menus = qobject_cast<const QMenuBar*>(widget)) {
      for (auto* action : menus->actions()) {
        check(action->text(), *widget);
        if (action->menu() != nullptr) checkMenu(*action->menu(), found);
      }
    }
  }
  for (const auto& [letter, texts] : sharers) {
    if (texts.size() > 1 && std::ranges::any_of(texts, [&](const QString& text) {
          return std::ranges::any_of(
              text, [&](QChar c) { return c.isLetter() && !sharers.contains(c.toUpper()); });
        })) {
      found << QStringLiteral("%1 share a letter, and others are free")
                   .arg(QStringList(texts.begin(), texts.end()).join(QStringLiteral(", ")));
    }
  }
  return found;
}

namespace {

/// Stops of Tab that lie above the stop before them. Those in one row may be of unequal height, and
/// columns beside each other have orders of their own.
void collectStepsUp(QWidget& dialog, QStringList& found) {
  std::vector<QWidget*> stops;
  for (auto* next = dialog.nextInFocusChain(); next != &dialog; next = next->nextInFocusChain()) {
    if (next->isVisible() && isExpectedStop(*next) && !isInner(*next)) stops.push_back(next);
  }
  for (std::size_t i = 1; i < stops.size(); ++i) {
    const QRect before = placeOf(stops[i - 1]);
    const QRect now = placeOf(stops[i]);
    const bool isBelowOrInRow = now.bottom() > before.top();
    const bool isScrolledAlike = scrollAreaOf(*stops[i - 1]) == scrollAreaOf(*stops[i]);
    const bool isInColumn = now.left() < before.right() && before.left() < now.right();
    if (isBelowOrInRow || !isInColumn || !isScrolledAlike) continue;
    found << QStringLiteral("Tab goes up from %1 to %2")
                 .arg(nameOf(*stops[i - 1]), nameOf(*stops[i]));
  }
}

}  // namespace

QStringList outOfOrder(QWidget& dialog) {
  QStringList found;
  collectStepsUp(dialog, found);
  const QWidget* action = nullptr;
  for (const auto* button : dialog.findChildren<QPushButton*>()) {
    const auto role = button->property("role").toString();
    const bool isAction = role == QStringLiteral("main") || role == QStringLiteral("danger");
    if (isAction && button->isVisible()) action = button;
  }
  for (const auto* other : dialog.findChildren<QPushButton*>()) {
    if (action == nullptr || other == action || !other->isVisible()) continue;
    const QRect place = placeOf(other);
    const QRect end = placeOf(action);
    const bool isBeside = place.top() < end.bottom() && end.top() < place.bottom();
    if (isBeside && place.left() > end.left()) {
      found << nameOf(*other) + QStringLiteral(" is to the right of the action");
    }
  }
  const auto* focused = dialog.focusWidget();
  const auto* button = qobject_cast<const QPushButton*>(focused);
  const bool isWayOut = button != nullptr && button->text().remove(u'&') == QStringLiteral("Close");
  const bool hasNothingToEnter = qobject_cast<const QTextBrowser*>(focused) != nullptr ||
                                 qobject_cast<const QTableView*>(focused) != nullptr;
  if (hasNothingToEnter || (isWayOut && dialog.findChild<QLineEdit*>() != nullptr)) {
    found << QStringLiteral("begins at ") + nameOf(*focused);
  }
  return found;
}

}  // namespace tests
