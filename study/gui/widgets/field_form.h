#pragma once

#include <QFormLayout>
#include <QString>
#include <QWidget>

namespace study::gui {

/// A form whose labels are level with the middle of fields of one line. QFormLayout alone gives a
/// label 7/4 of its own height, which is less than a field has.
class FieldForm final : public QFormLayout {
 public:
  using QFormLayout::addRow;
  using QFormLayout::QFormLayout;
  /// @param words  may be empty: the field is its own label, as a check box is
  void addRow(const QString& words, QWidget* field);
};

}  // namespace study::gui
