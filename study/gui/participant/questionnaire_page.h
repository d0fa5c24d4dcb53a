#pragma once

#include <map>
#include <vector>

#include <QElapsedTimer>
#include <QWidget>

#include "study/gui/participant/item_widget.h"
#include "study/model/given_answer.h"

namespace study::gui {

/// A questionnaire to fill in. It shows items and emits responses; it does not save them.
class QuestionnairePage final : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString title;
    QString introduction;
    std::vector<questionnaires::Item> items;
    ItemWidget::Choices choices;
    QString language;
    std::vector<GivenAnswer> before;  ///< answers given earlier
  };

  explicit QuestionnairePage(const Content& content, QWidget* parent = nullptr);

  /// Whether every required item has a valid answer.
  bool isComplete() const;

  /// Emits the answers that have been entered but not emitted yet, or that could not be saved.
  void flush();

 public slots:
  /// Marks an item's answer as not saved. It is emitted again by flush().
  void markUnsaved(const QString& item);

 signals:
  /// An item was answered, or its answer changed.
  void answered(const study::GivenAnswer& answer);
  /// An item's answer was removed.
  void retracted(const QString& item);
  void completeChanged(bool isComplete);

 private:
  struct ItemState {
    std::optional<questionnaires::Response> response;  ///< the last one emitted
    double firstTouch = 0.0;                           ///< since the page was shown [s]
    int changes = -1;     ///< of the answer after the first; −1: unanswered
    bool isSaved = true;  ///< false after markUnsaved()
  };

  void emitAnswer(std::size_t index);

  std::vector<ItemWidget*> widgets_;
  std::vector<ItemState> states_;
  QString language_;
  QElapsedTimer shown_;
};

}  // namespace study::gui
