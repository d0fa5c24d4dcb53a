#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace study::gui {

/// The real thing, on the physical tool: what to do, and a large button for every cut that was
/// made.
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
