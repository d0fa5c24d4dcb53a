#pragma once

#include <map>
#include <memory>
#include <string>

#include <QBoxLayout>
#include <QMainWindow>
#include <QMenu>
#include <QStackedWidget>

#include "study/gui/participant/participant_window.h"
#include "study/gui/session/catalogue_translator.h"
#include "study/gui/session/cut_key.h"
#include "study/gui/session/operator_pin.h"
#include "study/gui/session/session_controller.h"
#include "study/gui/session/station_push.h"
#include "study/gui/session/stop_key.h"
#include "study/trial/device_set.h"

namespace study::gui {

class QuestionnairePage;
class ControlPanel;
class SessionsPage;
class DevicePanel;
class PageMirror;
class TimelineTable;
class TrialPanel;

/// The operator's window: the list of sessions, the state of the running session, the state of the
/// device and its timing, and a large stop button that switches the force off at once. It shows
/// alternatives but never conditions.
class OperatorWindow final : public QMainWindow {
  Q_OBJECT

 public:
  /// The study must outlive the window.
  /// @param deviceFile  the laboratory's device file; empty: the study's own, or else virtual
  /// devices.
  /// @throws UserError  if the device file cannot be used.
  explicit OperatorWindow(
      Study& study, const std::string& deviceFile = {}, QWidget* parent = nullptr);
  ~OperatorWindow() override;

  /// Begins a session and opens the participant's window.
  void enrol(const Enrolment& enrolment);
  /// Resumes an interrupted session.
  /// @param takeOver  the reason for taking the session over from a computer that is gone; empty:
  /// no takeover.
  void resume(SessionId id, const std::string& takeOver = {});
  /// Checks devices and texts, then enrols. If a check fails, the operator decides; but no live
  /// session begins with blanks in its texts.
  void enrolAfterChecks(const Enrolment& enrolment);
  /// Checks the devices, then resumes. If a check fails, or virtual devices would go on in place of
  /// an instrument, the operator decides.
  void resumeAfterChecks(SessionId id, const std::string& takeOver = {});

  SessionController* controller() const noexcept { return controller_.get(); }
  ParticipantWindow* participantWindow() const noexcept { return participant_.get(); }
  /// The devices. Tests use this to disconnect one.
  DeviceSet& deviceSet() noexcept { return *deviceSet_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  /// Creates the window's contents in the language of the desk.
  void makeContents();
  void makeMenus();
  void arrange();
  void tile();
  QWidget* makeHead();
  QWidget* makeSession();
  void connectPanels();
  bool confirmVirtualDevices(SessionId id);
  void begin(Session session);
  void followSession();
  void showParticipant();
  void handOver();
  void showError(const QString& why);
  void takeScreenBack();
  void showWaitingErrors();
  void stop();
  void showInterview();
  void removeInterview();
  void endSession();
  void updateAll();
  void switchForces(bool areShown);
  void showForces(bool areShown);
  void useSessionLanguage();

  Study& study_;
  PointerHands hands_;
  std::unique_ptr<DeviceSet> deviceSet_;
  std::unique_ptr<SessionController> controller_;
  std::unique_ptr<ParticipantWindow> participant_;
  CatalogueTranslator translator_;
  OperatorPin pin_;
  StopKey stopKey_;
  CutKey cutKey_;
  QStringList waitingErrors_;  ///< messages that wait until the participant's window is unlocked
  QBoxLayout* columns_ = nullptr;  ///< of the page during a session
  QWidget* head_ = nullptr;
  StationPush push_;
  std::string language_;                    ///< of the present contents
  QMenu* languages_ = nullptr;              ///< to choose from, between sessions
  QStackedWidget* pages_ = nullptr;         ///< between sessions, and during a session
  QStackedWidget* sessionPages_ = nullptr;  ///< during a session: the trial, or the interview
  QuestionnairePage* interview_ = nullptr;
  SessionsPage* sessions_ = nullptr;
  ControlPanel* controls_ = nullptr;
  TrialPanel* trial_ = nullptr;
  TimelineTable* steps_ = nullptr;
  QAction* forces_ = nullptr;  ///< whether the operator sees the forces
  DevicePanel* devices_ = nullptr;
  PageMirror* mirror_ = nullptr;
};

}  // namespace study::gui
