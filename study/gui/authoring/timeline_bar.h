#pragma once

#include <vector>

#include <QString>
#include <QWidget>

namespace study::gui {

/// A session as a bar whose segments are as long as the phases last. Phases on the device are
/// filled, phases of reading and answering are outlined. A label below names each.
class TimelineBar final : public QWidget {
  Q_OBJECT

 public:
  struct Part {
    QString name;
    double seconds = 0.0;
    bool isFelt = false;
  };

  explicit TimelineBar(QWidget* parent = nullptr);

  void show(std::vector<Part> parts);
  using QWidget::show;

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<Part> parts_;
  double whole_ = 0.0;  ///< [s]
};

}  // namespace study::gui
