#pragma once

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "study/gui/desk/self_test.h"

namespace study::gui {

/// Whether this computer is fit for a study day: devices, clock, database, screen; each with what
/// was measured and what to do about it.
class SelfTestDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit SelfTestDialog(SelfTestOrder order, QWidget* parent = nullptr);

 public slots:
  void test();

 private:
  void fill(const std::vector<SelfTestLine>& lines);

  SelfTestOrder order_;
  QLabel* outcome_;
  QTableWidget* table_;
};

}  // namespace study::gui
