#pragma once

#include <QLabel>
#include <QWidget>

namespace study::gui {

/// How many cuts have been made of those that are needed, large enough to be read from a few
/// metres: a dot for each, filled once it is made, above the words.
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

  int needed_;
  int made_ = 0;
  QLabel* words_;
};

}  // namespace study::gui
