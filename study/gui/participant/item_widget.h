#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QElapsedTimer>
#include <QString>
#include <QWidget>

#include "questionnaires/model/answer.h"

namespace study::gui {

/// One question, to be answered. Shows a value and hands over a value; nothing is chosen
/// beforehand.
class ItemWidget : public QWidget {
  Q_OBJECT

 public:
  /// What may be chosen where the item takes its options from elsewhere: id and text.
  struct Choices {
    std::vector<std::pair<std::string, QString>> alternatives;
  };

  ItemWidget(const questionnaires::Item& item, const QString& language, QWidget* parent);

  const questionnaires::Item& item() const noexcept { return item_; }

  /// Nothing while it is not answered.
  virtual std::optional<questionnaires::Response> response() const = 0;
  /// Shows what was answered before, without emitting changed().
  virtual void show(const questionnaires::Response& response) = 0;

 signals:
  void changed();

 protected:
  QString text(const questionnaires::LocalizedText& text) const;

 private:
  questionnaires::Item item_;
  QString language_;
};

/// The widget for @p item.
ItemWidget* makeItemWidget(
    const questionnaires::Item& item,
    const ItemWidget::Choices& choices,
    const QString& language,
    QWidget* parent);

}  // namespace study::gui
