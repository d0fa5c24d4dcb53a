#pragma once

#include <QLineEdit>
#include <QPlainTextEdit>
#include <QTimer>

#include "study/gui/participant/answer_slider.h"
#include "study/gui/participant/item_widget.h"

namespace study::gui {

/// A position on a slider between two ends.
class SliderItem final : public ItemWidget {
  Q_OBJECT

 public:
  SliderItem(const questionnaires::Item& item, const QString& language, QWidget* parent);
  std::optional<questionnaires::Response> response() const override;
  void show(const questionnaires::Response& response) override;

 private:
  double step() const noexcept;

  AnswerSlider* slider_;
};

/// A typed number, with a decimal point or comma.
class NumberItem final : public ItemWidget {
  Q_OBJECT

 public:
  NumberItem(const questionnaires::Item& item, const QString& language, QWidget* parent);
  std::optional<questionnaires::Response> response() const override;
  void show(const questionnaires::Response& response) override;

 private:
  QLineEdit* line_;
};

/// Free text of one line or several. changed() is emitted when typing pauses.
class TextItem final : public ItemWidget {
  Q_OBJECT

 public:
  TextItem(const questionnaires::Item& item, const QString& language, QWidget* parent);
  std::optional<questionnaires::Response> response() const override;
  void show(const questionnaires::Response& response) override;

 private:
  QString typedText() const;

  QLineEdit* line_ = nullptr;
  QPlainTextEdit* lines_ = nullptr;
  QTimer* pauseTimer_;
};

}  // namespace study::gui
