#pragma once

#include <QLabel>
#include <QPushButton>
#include <QWidget>

namespace study::gui {

class CutCounter;
class Stage;

/// A page for cuts with the physical tool: an instruction, how many cuts were counted, and what
/// happens next. The operator counts them, because the participant has both hands full.
class BenchmarkPage final : public QWidget {
  Q_OBJECT

 public:
  struct Content {
    QString text;  ///< Markdown: what to do
    int minimumCuts = 3;
    QString next;  ///< on the button that goes on
  };

  /// @param picture  of the tool, of which the page takes ownership; nullptr: none.
  BenchmarkPage(const Content& content, QWidget* picture, QWidget* parent = nullptr);

  void setCuts(int cuts);

 signals:
  void finishRequested();

 private:
  int minimumCuts_;
  Stage* stage_;
  CutCounter* cutCounter_;
  QLabel* enoughHint_;  ///< says that no more cuts are needed
  QPushButton* next_;
};

}  // namespace study::gui
