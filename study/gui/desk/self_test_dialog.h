#pragma once

#include <QCheckBox>
#include <QDialog>
#include <QLabel>
#include <QPushButton>

#include "study/gui/desk/self_test.h"
#include "study/gui/widgets/findings_table.h"

namespace study::gui {

/// Tests whether this computer is ready for a study: devices, timing, saving and screen. Shows for
/// each, in everyday words, the finding and what to do, and on demand the measured values.
class SelfTestDialog final : public QDialog {
  Q_OBJECT

 public:
  explicit SelfTestDialog(SelfTestOptions options, QWidget* parent = nullptr);

 public slots:
  void test();

 private:
  void fill();

  SelfTestOptions options_;
  std::vector<FindingLine> lines_;  ///< of the last test
  QLabel* outcome_;
  FindingsTable* table_;
  QCheckBox* details_;
  QPushButton* beginButton_;
};

}  // namespace study::gui
