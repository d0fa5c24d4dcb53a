#pragma once

#include <QScrollArea>

namespace study::gui {

/// Gives its widget the size of the window as long as the widget fits in, and scrolls it where the
/// window is smaller than the widget's minimum. A plain scroll area would scroll as soon as the
/// preferred height is missing.
class FittingScroll final : public QScrollArea {
 public:
  FittingScroll(QWidget* inside, QWidget* parent);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();
};

}  // namespace study::gui
