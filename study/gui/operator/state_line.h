#pragma once

#include <QLabel>
#include <QWidget>

namespace haptics::devices {
struct DeviceKind;
}

namespace study::gui {

class SessionController;

/// What is felt just now, below the button that stops it: the device and its state, in green while
/// a trial runs and in red after one broke off, and the strokes of the trial. Between trials also
/// whether the disk is almost full.
class StateLine final : public QWidget {
  Q_OBJECT

 public:
  explicit StateLine(QWidget* parent = nullptr);

  /// Shows the state of @p controller's session; nullptr: no session is open.
  void showState(const SessionController* controller);
  /// Shows how many strokes of the running trial are made.
  void showCount(const SessionController& controller);

 private:
  /// Runs well, gives no force on purpose, broke off.
  enum class Health { Good, NoForce, Bad };

  void show(const QString& words, Health health);
  void showCount(int made, int asked, const haptics::devices::DeviceKind& device);

  QLabel* health_;
  QLabel* disk_;  ///< that the disk is almost full
  QLabel* count_;
};

}  // namespace study::gui
