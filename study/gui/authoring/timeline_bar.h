#pragma once

#include <vector>

#include <QString>
#include <QWidget>

namespace study::gui {

/// A session as a bar with a segment for each phase, its length proportional to the duration. The
/// time on the device is filled. A segment shows the name of its phase, or only the number if the
/// name does not fit.
class TimelineBar final : public QWidget {
  Q_OBJECT

 public:
  struct Period {
    double seconds = 0.0;
    bool isOnDevice = false;  ///< on the device
  };
  struct Part {
    QString name;
    std::vector<Period> periods;  ///< one after the other

    double seconds() const noexcept;
  };

  explicit TimelineBar(QWidget* parent = nullptr);

  void show(std::vector<Part> parts);
  const std::vector<Part>& parts() const noexcept { return parts_; }
  using QWidget::show;

  QSize sizeHint() const override;

 protected:
  void paintEvent(QPaintEvent* event) override;

 private:
  std::vector<Part> parts_;
  double totalSeconds_ = 0.0;  ///< [s]
};

}  // namespace study::gui
