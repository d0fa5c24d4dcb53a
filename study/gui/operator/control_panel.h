#pragma once

#include <vector>

#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>

#include "study/gui/widgets/messages.h"
#include "study/model/session_state.h"

namespace study::gui {

class SessionController;

/// The operator's buttons. Each is enabled only while the session allows its action, and each
/// exceptional action asks for a reason. The stop button stays visible on low screens.
class ControlPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit ControlPanel(QWidget* parent = nullptr);

  /// Shows @p controller's session; nullptr: no session is open.
  void setController(SessionController* controller);
  void refresh();
  QPushButton* stopButton() const noexcept { return stop_; }

 signals:
  void interviewFinished();
  /// The operator hands the screen to the participant.
  void handOverRequested();
  /// The participant asks for a copy of the consent they gave.
  void consentCopyRequested();
  void closeSessionRequested();

 private:
  using Perform = void (SessionController::*)(const QString& reason);
  /// @param help  the tool tip while the button is enabled
  QPushButton* add(
      const QString& text,
      SessionEvent event,
      MessageTopic topic,
      Perform action,
      const QString& help = {});
  static QString whyNot(SessionEvent event, bool isRunning);
  QWidget* makeButtons();
  QHBoxLayout* addGroup(
      QVBoxLayout& layout,
      const QString& title,
      const std::vector<std::vector<QPushButton*>>& rows);
  void keepFocusOffButtons();
  void connectButtons();
  void showParticipant();
  void performWithReason(Perform action, MessageTopic topic);
  void saveNote();
  void showNotes();

  struct SessionAction {
    QPushButton* button;
    SessionEvent event;
    QString help;
  };

  SessionController* controller_ = nullptr;
  QLabel* participantLabel_;
  QLabel* cohort_;
  QLabel* nowHeading_ = nullptr;  ///< the heading of what can be done now
  QPushButton* stop_;
  QPushButton* pause_ = nullptr;
  QPushButton* resume_;
  QPushButton* interviewDone_;
  QPushButton* countCut_;
  QPushButton* handOver_;
  QPushButton* consent_;
  QPushButton* close_;
  QLineEdit* note_;
  QListWidget* notes_;
  std::vector<SessionAction> choices_;
  std::vector<QPushButton*> endingButtons_;  ///< end the session
};

}  // namespace study::gui
