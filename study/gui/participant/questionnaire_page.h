#pragma once

#include <vector>

#include <QElapsedTimer>
#include <QFrame>
#include <QLabel>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>

#include "study/gui/participant/item_widget.h"
#include "study/gui/participant/page_scroll.h"
#include "study/model/given_answer.h"

namespace study::gui {

/// A questionnaire to fill in, one sheet at a time. It shows items and emits responses; it does not
/// save them.
class QuestionnairePage final : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString title;
    QString introduction;  ///< Markdown, see textLabel()
    std::vector<questionnaires::Item> items = {};
    ItemWidget::Choices choices = {};
    QString language;
    std::vector<GivenAnswer> before = {};  ///< answers given earlier
  };

  explicit QuestionnairePage(const Content& content, QWidget* parent = nullptr);

  /// Whether every required item that is asked has a valid answer.
  bool isComplete() const;

  /// The questions of the sheet that must be answered, and how many of them are not.
  struct Progress {
    int open = 0;
    int required = 0;
  };
  Progress progress() const;

  /// Marks the questions of the sheet that must still be answered, scrolls to the first of them and
  /// focuses it.
  void scrollToFirstUnanswered();

  /// Whether a part of the sheet is below the lower edge of the page.
  bool hasMoreBelow() const { return scroll_->hasMoreBelow(); }

  int sheet() const noexcept { return sheet_; }  ///< index of the sheet that is shown
  /// Number of sheets that the questionnaire is divided into.
  int sheets() const noexcept { return static_cast<int>(sheets_.size()); }
  /// Shows the next sheet, or the one before, on which something is asked.
  /// @return false, with nothing changed, if there is none.
  bool turnSheet(bool isForward);

  /// Emits the answers that have been entered but not emitted yet, or that could not be saved.
  void flush();

 public slots:
  /// Marks an item's answer as not saved. It is emitted again by flush().
  void markUnsaved(const QString& item);

 signals:
  /// An item was answered, or its answer changed.
  void answered(const study::GivenAnswer& answer);
  /// An item's answer was removed, or the item is no longer asked.
  void retracted(const QString& item);
  /// Emitted after each of the two.
  void progressChanged();
  /// hasMoreBelow() may have changed.
  void scrolled();

 private:
  struct ItemState {
    std::optional<questionnaires::Response> response;  ///< the last one emitted
    double firstTouch = 0.0;                           ///< since its sheet was shown [s]
    int changes = -1;     ///< of the answer after the first; −1: unanswered
    bool isSaved = true;  ///< false after markUnsaved()
  };
  struct Entry {
    ItemWidget* widget = nullptr;
    QFrame* card = nullptr;  ///< the frame around it, with its signature if it asks for consent
    QLabel* mark = nullptr;  ///< "Please answer this one"
    int sheet = 0;
    bool isAsked = true;
    ItemState state = {};
  };

  void addContents(const Content& content);
  QWidget* makeTerms(const QString& introduction);
  QWidget* makeTextInLines(const QString& markdown);
  QWidget* makeText(const QString& introduction);
  void addSheet();
  void addItem(const Content& content, std::size_t index);
  QFrame* addCard();
  QFrame* clauseOf(const QString& text);
  std::optional<questionnaires::Response> responseOf(const Entry& entry) const;
  bool isOpen(const Entry& entry) const;
  void mark(Entry& entry, bool isOpen);
  void emitAnswer(std::size_t index);
  void updateAskedItems();
  void ignorePresses();
  double now() const;

  PageScroll* scroll_;
  QWidget* scrollContents_;       ///< of it
  QVBoxLayout* place_ = nullptr;  ///< layout that contains the sheets
  std::vector<QWidget*> sheets_;
  std::vector<double> shownAt_;  ///< when each sheet was first shown [s]; −1: not yet
  int sheet_ = 0;
  std::vector<Entry> entries_;
  std::vector<questionnaires::Item> items_;
  QString language_;
  QElapsedTimer shown_;
  QTimer* ignoreTimer_;  ///< runs while presses are ignored, because questions have moved
};

}  // namespace study::gui
