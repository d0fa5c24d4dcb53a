#pragma once

#include <QSlider>

namespace study::gui {

/// A slider without a default value. It draws no handle until it is first used.
class AnswerSlider final : public QSlider {
  Q_OBJECT

 public:
  explicit AnswerSlider(QWidget* parent = nullptr);

  bool isTouched() const noexcept { return isTouched_; }
  /// Shows @p position as the answer.
  void setAnswer(int position);

 signals:
  void answered(int position);

 protected:
  void paintEvent(QPaintEvent* event) override;
  void mousePressEvent(QMouseEvent* event) override;
  void mouseMoveEvent(QMouseEvent* event) override;
  void keyPressEvent(QKeyEvent* event) override;

 private:
  void setFromPosition(const QPointF& position);

  bool isTouched_ = false;
};

}  // namespace study::gui
