#pragma once

#include <QLabel>
#include <QWidget>

namespace study::gui {

/// Shows how many of the needed cuts were made, large enough to be read from a few metres: a dot
/// for each cut, filled once it is made, and a text below.
class CutCounter final : public QWidget {
  Q_OBJECT

 public:
  explicit CutCounter(int needed, QWidget* parent = nullptr);

  /// @param words  such as "Cuts: 1 of at least 3".
  void setCount(int made, const QString& words);

 protected:
  void paintEvent(QPaintEvent* event) override;
  bool event(QEvent* event) override;

 private:
  int radius() const noexcept;
  void makeRoomForDots();

  int cutsNeeded_;
  int cutsMade_ = 0;
  QLabel* words_;
};

}  // namespace study::gui
