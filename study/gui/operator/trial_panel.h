#pragma once

#include <QBoxLayout>
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

/// The running trial: its timing and, unless they are hidden, its forces over time and travel and
/// the landmarks of its cuts. Forces tell conditions apart, so a blinded session hides them.
class TrialPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit TrialPanel(QWidget* parent = nullptr);

  /// Shows @p controller's session; nullptr: no session is open. The controller must live until the
  /// next call.
  void setController(SessionController* controller);
  /// Follows a change of step.
  void updateStep();
  /// Shows new samples of the running trial.
  void updateTrial();
  /// Shows everything that tells how large the force is, or hides it.
  void showForces(bool areShown);
  /// Puts @p steps, which have no other place while the forces are hidden, into this panel.
  void takeSteps(TimelineTable& steps);
  /// Closes the window with the coloured bone, which only the operator may see.
  void closeBoneWindow();

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  void beginTrial();
  /// Removes the curves of a trial that is over, once another one is next.
  void clearBeforeNextTrial();
  /// Clears all trial displays for a trial on @p device with ticks at @p rate [Hz].
  void clearTrial(const haptics::devices::DeviceKind& device, double rate);
  void showNumbers();

  SessionController* controller_ = nullptr;
  QLabel* numbers_;
  BoneColoursButton* boneColours_;
  QBoxLayout* plots_;
  LivePlot* plot_;
  TravelPlot* travel_;
  ServoPanel* servo_;
  CutTable* cuts_;
  bool wasRunning_ = false;
  bool areForcesShown_ = true;
};

}  // namespace study::gui
