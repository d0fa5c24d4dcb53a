#pragma once

#include <QLabel>
#include <QWidget>

#include "study/gui/session/session_controller.h"

namespace study::gui {

class CupButton;
class CutTable;
class LivePlot;
class ServoPanel;
class TimelineTable;

/// Where the session is, step by step, and what is felt just now: force, position and velocity, the
/// cuts, and how punctually it is rendered. Red until healthy.
class TrialPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit TrialPanel(QWidget* parent = nullptr);

  /// Nothing where no session is open. The controller outlives the next call.
  void follow(SessionController* controller);
  /// The steps have changed.
  void updateSteps();
  /// New numbers from a running trial.
  void updateTrial();
  /// What an operator alone may see of the bone is seen no longer.
  void closeBone();

 private:
  enum class Health { Good, Resting, Bad };

  void beginTrial();
  /// Empties what tells of a trial, for one on such a device, of ticks at @p rate [Hz].
  void showNothing(const haptics::devices::DeviceKind& device, double rate);
  void showHealth(const QString& words, Health health);
  void showState();

  SessionController* controller_ = nullptr;
  TimelineTable* steps_;
  QLabel* health_;
  QLabel* cutCount_;
  QLabel* numbers_;
  CupButton* cup_;
  LivePlot* plot_;
  ServoPanel* servo_;
  CutTable* cuts_;
  bool wasRunning_ = false;
};

}  // namespace study::gui
