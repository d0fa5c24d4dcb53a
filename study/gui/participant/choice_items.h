#pragma once

#include <vector>

#include <QCheckBox>

#include "study/gui/participant/item_widget.h"
#include "study/gui/participant/option_buttons.h"

namespace study::gui {

/// A point on a scale between two ends: agreement with a statement, or a place between two words.
class PointItem final : public ItemWidget {
  Q_OBJECT

 public:
  PointItem(const questionnaires::Item& item, const QString& language, QWidget* parent);
  std::optional<questionnaires::Response> response() const override;
  void show(const questionnaires::Response& response) override;

 private:
  void addWordsBelow(int columns, const QString& low, const QString& high);

  OptionButtons* buttons_;
};

/// One of several options: written ones, or the alternatives that were felt.
class ChoiceItem final : public ItemWidget {
  Q_OBJECT

 public:
  ChoiceItem(
      const questionnaires::Item& item,
      const Choices& choices,
      const QString& language,
      QWidget* parent);
  std::optional<questionnaires::Response> response() const override;
  void show(const questionnaires::Response& response) override;

 private:
  std::vector<std::string> ids_;
  OptionButtons* buttons_;
};

/// Several options of which any number can be ticked.
class MultipleChoiceItem final : public ItemWidget {
  Q_OBJECT

 public:
  MultipleChoiceItem(const questionnaires::Item& item, const QString& language, QWidget* parent);
  std::optional<questionnaires::Response> response() const override;
  void show(const questionnaires::Response& response) override;

 private:
  std::vector<QCheckBox*> boxes_;
};

}  // namespace study::gui
