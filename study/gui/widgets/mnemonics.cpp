#include "study/gui/widgets/mnemonics.h"

#include <algorithm>
#include <functional>
#include <map>
#include <set>
#include <utility>
#include <vector>

#include <QAbstractButton>
#include <QAction>
#include <QEvent>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QTabBar>

namespace study::gui {
namespace {

constexpr const char* kNoMnemonicsProperty = "plain-page";

/// A text that can have a mnemonic, and how it is changed.
struct Place {
  QString text;
  std::function<void(const QString&)> write;
};

bool isPlain(const QWidget& widget) {
  for (const auto* up = &widget; up != nullptr; up = up->parentWidget()) {
    if (up->property(kNoMnemonicsProperty).toBool()) return true;
  }
  return false;
}

void addActions(const QWidget& of, std::vector<Place>& places) {
  for (auto* action : of.actions()) {
    if (action->isSeparator()) continue;
    places.push_back({action->text(), [action](const QString& text) { action->setText(text); }});
  }
}

void addTabs(QTabBar& tabs, std::vector<Place>& places) {
  for (int tab = 0; tab < tabs.count(); ++tab) {
    places.push_back(
        {tabs.tabText(tab), [&tabs, tab](const QString& text) { tabs.setTabText(tab, text); }});
  }
}

std::vector<Place> placesIn(QWidget& window) {
  std::vector<Place> places;
  if (qobject_cast<QMenu*>(&window) != nullptr) {
    addActions(window, places);
    return places;
  }
  for (auto* widget : window.findChildren<QWidget*>()) {
    if (widget->window() != &window || isPlain(*widget)) continue;
    if (auto* button = qobject_cast<QAbstractButton*>(widget)) {
      places.push_back({button->text(), [button](const QString& text) { button->setText(text); }});
    } else if (auto* label = qobject_cast<QLabel*>(widget); label != nullptr && label->buddy()) {
      places.push_back({label->text(), [label](const QString& text) { label->setText(text); }});
    } else if (auto* tabs = qobject_cast<QTabBar*>(widget)) {
      addTabs(*tabs, places);
    } else if (qobject_cast<QMenuBar*>(widget) != nullptr) {
      addActions(*widget, places);
    }
  }
  return places;
}

/// The positions of letters and digits in @p text: first the initials of words, then all others.
/// Text after a tab is the name of a key and is ignored.
std::vector<qsizetype> lettersOf(const QString& text) {
  std::vector<qsizetype> first;
  std::vector<qsizetype> other;
  const qsizetype end = text.indexOf(u'\t') < 0 ? text.size() : text.indexOf(u'\t');
  for (qsizetype i = 0; i < end; ++i) {
    if (!text[i].isLetterOrNumber()) continue;
    (i == 0 || text[i - 1].isSpace() ? first : other).push_back(i);
  }
  first.insert(first.end(), other.begin(), other.end());
  return first;
}

/// Assigns letters to texts, if possible a different one to each: a bipartite matching by
/// augmenting paths (Kuhn 1955). Equal texts share a letter, and Alt with this letter moves the
/// focus from one to the next.
class MnemonicAssignment {
 public:
  /// Records that @p text already has the mnemonic @p letter.
  void keep(const QString& text, QChar letter) {
    owners_.emplace(letter, text);
    kept_.insert(letter);
    known_.insert(text);
  }

  void assignLetter(const QString& text) {
    if (!known_.insert(text).second) return;
    std::set<QChar> tried;
    find(text, tried);
  }

  /// The position of the letter assigned to @p text; of the letter that the fewest texts share if
  /// all its letters are assigned to other texts; −1 if it has none.
  qsizetype placeIn(const QString& text) {
    const auto places = lettersOf(text);
    for (const auto at : places) {
      const auto owner = owners_.find(text[at].toUpper());
      if (owner != owners_.end() && owner->second == text) return at;
    }
    if (places.empty()) return -1;
    const auto [known, isNew] = sharedPlaces_.emplace(text, places.front());
    if (isNew) {
      known->second = *std::ranges::min_element(
          places, {}, [&](qsizetype at) { return sharers_[text[at].toUpper()]; });
      ++sharers_[text[known->second].toUpper()];
    }
    return known->second;
  }

 private:
  bool find(const QString& text, std::set<QChar>& tried) {
    for (const auto at : lettersOf(text)) {
      if (owners_.emplace(text[at].toUpper(), text).second) return true;
    }
    for (const auto at : lettersOf(text)) {
      const auto letter = text[at].toUpper();
      if (kept_.contains(letter) || !tried.insert(letter).second) continue;
      if (!find(QString(owners_[letter]), tried)) continue;
      owners_[letter] = text;  // its former owner was given another letter
      return true;
    }
    return false;
  }

  std::map<QChar, QString> owners_;
  std::set<QChar> kept_;
  std::set<QString> known_;
  std::map<QString, qsizetype> sharedPlaces_;  ///< of texts without a letter of their own
  std::map<QChar, int> sharers_;               ///< number of these texts with a letter
};

class MnemonicFilter final : public QObject {
 public:
  using QObject::QObject;

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override {
    const bool isShown = event->type() == QEvent::Show;
    if (!isShown && event->type() != QEvent::LayoutRequest) return false;
    auto* widget = qobject_cast<QWidget*>(watched);
    if (widget == nullptr || (isShown && !widget->isWindow())) return false;
    if (isShown || widget->isVisible()) addMnemonics(*widget->window());
    return false;
  }
};

}  // namespace

QChar mnemonicOf(const QString& text) {
  for (qsizetype i = 0; i + 1 < text.size(); ++i) {
    if (text[i] != u'&') continue;
    if (text[i + 1] != u'&') return text[i + 1].toUpper();
    ++i;
  }
  return {};
}

void addMnemonics(QWidget& window) {
  if (isPlain(window)) return;
  const auto places = placesIn(window);
  MnemonicAssignment assignment;
  for (const auto& place : places) {
    const auto letter = mnemonicOf(place.text);
    if (!letter.isNull()) assignment.keep(QString(place.text).remove(u'&'), letter);
  }
  for (const auto& place : places) {
    if (mnemonicOf(place.text).isNull()) assignment.assignLetter(place.text);
  }
  for (const auto& place : places) {
    if (!mnemonicOf(place.text).isNull()) continue;
    const auto at = assignment.placeIn(place.text);
    QString text = place.text;
    if (at >= 0) place.write(text.insert(at, u'&'));
  }
}

void installMnemonics(QApplication& application) {
  application.installEventFilter(new MnemonicFilter(&application));
}

void disableMnemonics(QWidget& page) {
  page.setProperty(kNoMnemonicsProperty, true);
}

}  // namespace study::gui
