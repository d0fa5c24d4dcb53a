#include "study/gui/widgets/field_form.h"

#include <algorithm>

#include <QAbstractButton>
#include <QLabel>

namespace study::gui {
namespace {

class FieldLabel final : public QLabel {
 public:
  FieldLabel(const QString& words, QWidget* field) : QLabel(words) { setBuddy(field); }

  QSize sizeHint() const override { return asHighAsTheField(QLabel::sizeHint()); }
  QSize minimumSizeHint() const override { return asHighAsTheField(QLabel::minimumSizeHint()); }

 private:
  QSize asHighAsTheField(QSize own) const {
    constexpr int kMostLines = 3;  // a field with more lines has its label at the top
    if (buddy() == nullptr) return own;
    const int field = std::max(buddy()->sizeHint().height(), buddy()->minimumHeight());
    return field > kMostLines * own.height() ? own : own.expandedTo({0, field});
  }
};

}  // namespace

void nameAsLabelled(QWidget* field, const QString& words) {
  const bool hasOwnWords = qobject_cast<QAbstractButton*>(field) != nullptr;
  if (field->focusPolicy() == Qt::NoFocus || hasOwnWords) return;
  if (field->accessibleName().isEmpty()) field->setAccessibleName(words);
}

void FieldForm::addRow(const QString& words, QWidget* field) {
  nameAsLabelled(field, words);
  QFormLayout::addRow(words.isEmpty() ? nullptr : new FieldLabel(words, field), field);
}

}  // namespace study::gui
