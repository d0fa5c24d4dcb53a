#pragma once

#include <optional>
#include <string>
#include <vector>

#include <QBoxLayout>
#include <QLabel>
#include <QString>
#include <QWidget>

#include "questionnaires/model/answer.h"

namespace study::gui {

/// The widget of one questionnaire item. It shows and returns a response. No option is selected by
/// default.
class ItemWidget : public QWidget {
  Q_OBJECT

 public:
  /// The options, as id and text, of an item that does not list its own.
  struct Choices {
    struct Alternative {
      std::string id;
      QString name;
      QString note = {};  ///< below the name, such as "felt first"; may be empty
    };
    std::vector<Alternative> alternatives;
  };

  enum class StatementPlace {
    Above,   ///< above the field in which the answer is given
    Beside,  ///< beside that field, if there is room
  };

  ItemWidget(
      const questionnaires::Item& item,
      const QString& language,
      QWidget* parent,
      StatementPlace place = StatementPlace::Above);

  const questionnaires::Item& item() const noexcept { return item_; }

  /// Writes @p remark, such as "(optional)", after the statement.
  void addRemark(const QString& remark);
  /// Puts @p widget beside the field in which the answer is written.
  void putBesideField(QWidget& widget);

  /// The response; std::nullopt while the item is unanswered.
  virtual std::optional<questionnaires::Response> response() const = 0;
  /// Shows an earlier response without emitting changed().
  virtual void show(const questionnaires::Response& response) = 0;

  QSize minimumSizeHint() const override;

 signals:
  void changed();

 protected:
  void resizeEvent(QResizeEvent* event) override;
  /// The layout for widgets below or beside the statement.
  QVBoxLayout& rows() noexcept { return *rows_; }
  QString text(const questionnaires::LocalizedText& text) const;

 private:
  void showStatement(const QString& words);

  questionnaires::Item item_;
  QString language_;
  StatementPlace statementPlace_;
  QBoxLayout* parts_;  ///< the statement and the rows
  QWidget* field_;
  QVBoxLayout* rows_;
  QLabel* statement_ = nullptr;
};

/// Makes the widget for @p item.
ItemWidget* makeItemWidget(
    const questionnaires::Item& item,
    const ItemWidget::Choices& choices,
    const QString& language,
    QWidget* parent);

}  // namespace study::gui
