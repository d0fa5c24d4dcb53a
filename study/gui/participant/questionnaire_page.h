#pragma once

#include <map>
#include <vector>

#include <QElapsedTimer>
#include <QWidget>

#include "study/gui/participant/item_widget.h"
#include "study/model/given_answer.h"

namespace study::gui {

/// A questionnaire to be filled in. Shows and collects; what becomes of the answers is not its
/// business.
class QuestionnairePage final : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString title;
    QString introduction;
    std::vector<questionnaires::Item> items;
    ItemWidget::Choices choices;
    QString language;
    std::vector<GivenAnswer> before;  ///< what has been answered already
  };

  explicit QuestionnairePage(const Content& content, QWidget* parent = nullptr);

  /// Every required item has an answer.
  bool isComplete() const;

  /// Hands on whatever was written and has not been yet.
  void flush();

 public slots:
  /// An item's answer could not be kept: it is handed on once more, with the next or by flush().
  void takeBack(const QString& item);

 signals:
  /// An item has an answer, or another one.
  void answered(const study::GivenAnswer& answer);
  /// An item has none any more.
  void retracted(const QString& item);
  void completeChanged(bool isComplete);

 private:
  struct Told {
    std::optional<questionnaires::Response> response;  ///< as last handed on
    double firstTouch = 0.0;                           ///< [s]
    int changes = -1;                                  ///< −1: untouched
    bool isKept = true;                                ///< as far as anybody has said
  };

  void handOn(std::size_t index);

  std::vector<ItemWidget*> widgets_;
  std::vector<Told> told_;
  QString language_;
  QElapsedTimer shown_;
};

}  // namespace study::gui
