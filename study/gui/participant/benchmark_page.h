#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace study::gui {

/// A page for cuts with the physical tool: an instruction and a large button to press after each
/// cut.
class BenchmarkPage final : public QWidget {
  Q_OBJECT

 public:
  BenchmarkPage(const QString& text, int minimumCuts, QWidget* parent = nullptr);

  void setCuts(int cuts);

 signals:
  void cutMade();

 private:
  int minimumCuts_;
  QLabel* count_;
};

}  // namespace study::gui
