#include "study/gui/widgets/field_form.h"

#include <algorithm>

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

void FieldForm::addRow(const QString& words, QWidget* field) {
  QFormLayout::addRow(words.isEmpty() ? nullptr : new FieldLabel(words, field), field);
}

}  // namespace study::gui
