#pragma once

#include <QScrollArea>

namespace study::gui {

/// Resizes its widget to the window, and scrolls only if the window is smaller than the widget's
/// minimum size. A plain scroll area would scroll as soon as the window is lower than the preferred
/// height.
class FittingScroll final : public QScrollArea {
 public:
  FittingScroll(QWidget* inside, QWidget* parent);

 protected:
  void resizeEvent(QResizeEvent* event) override;
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  void fit();
};

/// Scrolls @p inside where the window is too small for it. It takes no focus itself: it scrolls to
/// what has the focus.
QScrollArea* scrolled(QWidget* inside, QWidget* parent);

}  // namespace study::gui
