#pragma once

#include <QLabel>
#include <QWidget>

namespace study::gui {

class CutCounter;

/// A page for cuts with the physical tool: an instruction, how many cuts were counted, and what
/// happens next. The operator counts them, because the participant has both hands full.
class BenchmarkPage final : public QWidget {
  Q_OBJECT

 public:
  /// @param picture  of the tool, of which the page takes ownership; nullptr: none.
  BenchmarkPage(const QString& text, int minimumCuts, QWidget* picture, QWidget* parent = nullptr);

  void setCuts(int cuts);

 private:
  int minimumCuts_;
  CutCounter* count_;
  QLabel* next_;  ///< what happens next
};

}  // namespace study::gui
