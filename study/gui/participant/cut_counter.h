#pragma once

#include <QLabel>
#include <QWidget>

namespace study::gui {

/// Shows how many of the needed cuts were made, large enough to be read from a few metres: a dot
/// for each cut, filled once it is made, and "2 of 3 cuts" beside or below the dots.
class CutCounter final : public QWidget {
  Q_OBJECT

 public:
  /// What is counted: "cut", and "cuts".
  struct StrokeWords {
    QString one;
    QString several;
  };
  CutCounter(int needed, const StrokeWords& strokes, QWidget* parent = nullptr);

  void setCount(int made);

  QSize sizeHint() const override;
  QSize minimumSizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  bool event(QEvent* event) override;

 private:
  int radius() const noexcept;
  int widthOfDots() const noexcept;
  bool isOneLine(int width) const;
  void arrange();

  int cutsNeeded_;
  int cutsMade_ = -1;
  StrokeWords strokeWords_;
  QLabel* words_;
};

}  // namespace study::gui
