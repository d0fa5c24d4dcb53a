#pragma once

#include <QBoxLayout>
#include <QString>
#include <QWidget>

namespace study::gui {

/// Fields beside each other, each below its name; in a narrow window below each other.
class FieldRow final : public QWidget {
  Q_OBJECT

 public:
  explicit FieldRow(QWidget* parent);

  void add(const QString& words, QWidget* field);

  QSize minimumSizeHint() const override;

 protected:
  bool event(QEvent* event) override;

 private:
  void fit();

  QBoxLayout* fields_;
};

}  // namespace study::gui
