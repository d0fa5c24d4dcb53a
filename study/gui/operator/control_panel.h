#pragma once

#include <vector>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QVBoxLayout>
#include <QWidget>

#include "study/gui/operator/state_line.h"
#include "study/gui/widgets/messages.h"
#include "study/model/session_state.h"

namespace study::gui {

class SessionController;
class TimelineTable;

/// The operator's buttons, with the state of the session. A button is shown only while the session
/// allows its action, and each exceptional action asks for a reason. The stop button, the state and
/// the count stay visible on low screens.
class ControlPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit ControlPanel(QWidget* parent = nullptr);

  /// Shows @p controller's session; nullptr: no session is open.
  void setController(SessionController* controller);
  void refresh();
  /// Shows how far the running trial is.
  void updateTrial();
  /// Puts @p steps below the buttons. They scroll by themselves only where that leaves the buttons
  /// in their place; otherwise both are scrolled together.
  void takeSteps(TimelineTable& steps);
  QPushButton* stopButton() const noexcept { return stop_; }

 signals:
  void interviewFinished();
  /// The operator hands the screen to the participant.
  void handOverRequested();
  /// The participant asks for a copy of the consent they gave.
  void consentCopyRequested();
  void closeSessionRequested();

 protected:
  /// Fits the steps when their place is resized.
  bool eventFilter(QObject* watched, QEvent* event) override;

 private:
  using Perform = void (SessionController::*)(const QString& reason);
  /// @param help  the tool tip
  QPushButton* add(
      const QString& text,
      SessionEvent event,
      MessageTopic topic,
      Perform action,
      const QString& help = {});
  QWidget* makeButtons();
  QLabel* addGroup(const QString& title, const std::vector<std::vector<QPushButton*>>& rows);
  bool mayDo(SessionEvent event) const;
  void keepFocusOffButtons();
  void connectButtons();
  void fitSteps();
  void showParticipant();
  void performWithReason(Perform action, MessageTopic topic);
  void saveNote();
  void showNotes();

  struct SessionAction {
    QPushButton* button;
    SessionEvent event;
  };

  SessionController* controller_ = nullptr;
  QLabel* participantLabel_;
  QLabel* cohort_;
  QPushButton* stop_;
  StateLine* state_;
  QLabel* now_ = nullptr;   ///< the heading of what can be done now
  QLabel* ends_ = nullptr;  ///< the heading of what ends the session
  QScrollArea* scroll_ = nullptr;
  QVBoxLayout* buttons_ = nullptr;
  TimelineTable* steps_ = nullptr;  ///< nullptr before they were here
  QPushButton* pause_ = nullptr;
  QPushButton* saveTrial_;
  QPushButton* resume_;
  QPushButton* interviewDone_;
  QPushButton* countCut_;
  QPushButton* uncountCut_;
  QPushButton* handOver_;
  QPushButton* consent_;
  QPushButton* close_;
  QLineEdit* note_;
  QListWidget* notes_;
  std::vector<SessionAction> choices_;
};

}  // namespace study::gui
