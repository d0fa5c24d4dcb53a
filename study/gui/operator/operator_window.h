#pragma once

#include <map>
#include <memory>
#include <string>

#include <QMainWindow>
#include <QStackedWidget>

#include "study/gui/participant/participant_window.h"
#include "study/gui/session/catalogue_translator.h"
#include "study/gui/session/operator_pin.h"
#include "study/gui/session/session_controller.h"
#include "study/gui/session/stop_key.h"
#include "study/trial/rig.h"

namespace study::gui {

class QuestionnairePage;
class ControlPanel;
class SessionsPage;
class DevicePanel;
class TrialPanel;

/// What the operator sees: who has taken part, where the present session is, how the device and its
/// clock are, and one large button that means no force at once. Knows alternatives, not conditions.
class OperatorWindow final : public QMainWindow {
  Q_OBJECT

 public:
  /// The study outlives it.
  /// @param deviceFile  of the laboratory; empty: the study's own, or else virtual instruments.
  /// @throws UserError  if it cannot be used.
  explicit OperatorWindow(
      Study& study, const std::string& deviceFile = {}, QWidget* parent = nullptr);
  ~OperatorWindow() override;

  /// Begins a session and shows it to the participant.
  void enrol(const Enrolment& enrolment);
  /// Goes on with one that was interrupted.
  void resume(SessionId id);
  /// The same after a check of devices and texts, where the operator does not think better of it.
  void enrolIfFit(const Enrolment& enrolment);
  /// Goes on after a check of the devices.
  void resumeIfFit(SessionId id);

  SessionController* controller() const noexcept { return controller_.get(); }
  ParticipantWindow* participantWindow() const noexcept { return participant_.get(); }
  /// The instruments, for trying out what happens when one is gone.
  Rig& rig() noexcept { return *rig_; }

 protected:
  void closeEvent(QCloseEvent* event) override;

 private:
  QWidget* makeHead();
  QWidget* makeSession();
  void connectPanels();
  void begin(Session session);
  void followSession();
  void showParticipant();
  void handOver();
  void tell(const QString& why);
  void tellWhatWaited();
  void stop();
  void showInterview();
  void endSession();
  /// Asks whether to go on though something could not be kept; No is what Enter says.
  bool wantsToLose();
  void updateAll();
  void moveHand(double share);
  void speakTheSessionsLanguage();

  Study& study_;
  std::map<std::string, haptics::devices::PointerHand*> hands_;  ///< of the open devices
  std::unique_ptr<Rig> rig_;
  std::unique_ptr<SessionController> controller_;
  std::unique_ptr<ParticipantWindow> participant_;
  CatalogueTranslator translator_;
  OperatorPin pin_;
  StopKey stopKey_;
  QStringList waiting_;     ///< what could not be told while the screen was the participant's
  QStackedWidget* pages_;   ///< between sessions, in a session
  QStackedWidget* middle_;  ///< of a session: the trial, the interview
  QuestionnairePage* interview_ = nullptr;
  SessionsPage* sessions_;
  ControlPanel* controls_;
  TrialPanel* trial_;
  DevicePanel* devices_;
};

}  // namespace study::gui
