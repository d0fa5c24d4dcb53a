#pragma once

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>

#include "study/gui/desk/self_test.h"

namespace study::gui {

/// Tests whether this computer is ready for a study: devices, clock, database and screen. Shows for
/// each the measured value and what to do.
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
