#include "tests/study/gui/visible_words.h"

#include <QAbstractButton>
#include <QAbstractItemView>
#include <QAccessible>
#include <QComboBox>
#include <QGroupBox>
#include <QLabel>
#include <QLineEdit>
#include <QPlainTextEdit>

namespace tests {
namespace {

void addModel(const QAbstractItemModel* model, std::set<QString>& words) {
  if (model == nullptr) return;
  for (int column = 0; column < model->columnCount(); ++column) {
    words.insert(model->headerData(column, Qt::Horizontal).toString());
    for (int row = 0; row < model->rowCount(); ++row) {
      const auto index = model->index(row, column);
      for (const int role : {Qt::DisplayRole, Qt::ToolTipRole, Qt::UserRole}) {
        words.insert(model->data(index, role).toString());
      }
    }
  }
}

void addAccessible(QAccessibleInterface* node, std::set<QString>& words) {
  if (node == nullptr || !node->isValid()) return;
  for (const auto text :
       {QAccessible::Name, QAccessible::Description, QAccessible::Value, QAccessible::Help}) {
    words.insert(node->text(text));
  }
  for (int i = 0; i < node->childCount(); ++i) addAccessible(node->child(i), words);
}

void addWidget(const QWidget* widget, std::set<QString>& words) {
  for (const auto& text :
       {widget->accessibleName(),
        widget->accessibleDescription(),
        widget->toolTip(),
        widget->objectName(),
        widget->windowTitle(),
        widget->statusTip(),
        widget->whatsThis()}) {
    words.insert(text);
  }
  if (const auto* label = qobject_cast<const QLabel*>(widget)) words.insert(label->text());
  if (const auto* button = qobject_cast<const QAbstractButton*>(widget)) {
    words.insert(button->text());
  }
  if (const auto* line = qobject_cast<const QLineEdit*>(widget)) {
    words.insert(line->placeholderText());
    words.insert(line->text());
  }
  if (const auto* text = qobject_cast<const QPlainTextEdit*>(widget)) {
    words.insert(text->placeholderText());
  }
  if (const auto* group = qobject_cast<const QGroupBox*>(widget)) words.insert(group->title());
  if (const auto* box = qobject_cast<const QComboBox*>(widget)) addModel(box->model(), words);
  if (const auto* view = qobject_cast<const QAbstractItemView*>(widget)) {
    addModel(view->model(), words);
  }
}

}  // namespace

std::set<QString> wordsIn(QWidget& window) {
  std::set<QString> words;
  addWidget(&window, words);
  const auto widgets = window.findChildren<QWidget*>();
  for (const auto* widget : widgets) addWidget(widget, words);
  addAccessible(QAccessible::queryAccessibleInterface(&window), words);
  words.erase(QString());
  return words;
}

}  // namespace tests
