#pragma once

#include <QFormLayout>
#include <QString>
#include <QWidget>

namespace study::gui {

/// Gives a control without words and without an accessible name the words of its label as name.
void nameAsLabelled(QWidget* field, const QString& words);

/// A form whose labels are vertically centred on fields of one line. QFormLayout alone gives a
/// label 7/4 of its own height, which is less than the height of a field.
class FieldForm final : public QFormLayout {
 public:
  using QFormLayout::addRow;
  using QFormLayout::QFormLayout;
  /// @param words  the label; empty: the field has its own, as a check box does
  void addRow(const QString& words, QWidget* field);
};

}  // namespace study::gui
