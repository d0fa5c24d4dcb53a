#pragma once

#include <QLabel>
#include <QTableWidget>
#include <QWidget>

#include "study/gui/live_plot.h"
#include "study/gui/session_controller.h"

namespace study::gui {

/// Where the session is, step by step, and how the device and its clock are: red until healthy.
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

 private:
  void showHealth(const QString& words, bool isHealthy);

  SessionController* controller_ = nullptr;
  QTableWidget* steps_;
  QLabel* health_;
  QLabel* cuts_;
  QLabel* clock_;
  LivePlot* plot_;
  bool wasRunning_ = false;
};

}  // namespace study::gui
