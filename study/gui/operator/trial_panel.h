#pragma once

#include <QLabel>
#include <QWidget>

#include "study/gui/session/session_controller.h"

namespace study::gui {

class BoneColoursButton;
class CutTable;
class LivePlot;
class ServoPanel;
class TimelineTable;
class TravelPlot;

/// The steps of the session and the running trial: force, position, velocity, cuts and timing. The
/// status label is green while a trial runs, and red after one broke off.
class TrialPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit TrialPanel(QWidget* parent = nullptr);

  /// Shows @p controller's session; nullptr: no session is open. The controller must live until the
  /// next call.
  void setController(SessionController* controller);
  /// Updates the table after a change of step.
  void updateSteps();
  /// Shows new samples of the running trial.
  void updateTrial();
  /// Closes the window with the coloured bone, which only the operator may see.
  void closeBoneWindow();

 private:
  /// The state of a trial, shown by the colour of its line: runs well, gives no force on purpose,
  /// broke off.
  enum class Health { Good, NoForce, Bad };

  void beginTrial();
  /// Removes the curves of a trial that is over, once another one is next.
  void clearBeforeNextTrial();
  /// Clears all trial displays for a trial on @p device with ticks at @p rate [Hz].
  void clearTrial(const haptics::devices::DeviceKind& device, double rate);
  void showHealth(const QString& words, Health health);
  void showState();

  SessionController* controller_ = nullptr;
  TimelineTable* steps_;
  QLabel* health_;
  QLabel* cutCount_;
  QLabel* numbers_;
  BoneColoursButton* boneColours_;
  LivePlot* plot_;
  TravelPlot* travel_;
  ServoPanel* servo_;
  CutTable* cuts_;
  bool wasRunning_ = false;
};

}  // namespace study::gui
