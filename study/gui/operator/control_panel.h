#pragma once

#include <vector>

#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QWidget>

#include "study/model/session_state.h"

namespace study::gui {

class SessionController;

/// What the operator may do, as far as the session allows it; every exceptional step asks for its
/// reason. However low the screen is, the button that stops stays in sight.
class ControlPanel final : public QWidget {
  Q_OBJECT

 public:
  explicit ControlPanel(QWidget* parent = nullptr);

  /// Nothing where no session is open.
  void follow(SessionController* controller);
  void refresh();
  QPushButton* stopButton() const noexcept { return stop_; }

 signals:
  void interviewFinished();
  /// The screen is to be the participant's.
  void handOverRequested();
  /// The participant wants a copy of what they agreed to.
  void consentCopyRequested();
  void closeSessionRequested();

 private:
  using Perform = void (SessionController::*)(const QString& reason);
  QPushButton* add(const QString& text, SessionEvent event, Perform action);
  QWidget* makeButtons();
  void connectButtons();
  void showWho();
  void askAndDo(Perform action, const QString& what, SessionEvent event);
  void keepNote();
  void showNotes();

  struct Choice {
    QPushButton* button;
    SessionEvent event;
  };

  SessionController* controller_ = nullptr;
  QLabel* who_;
  QLabel* cohort_;
  QPushButton* stop_;
  QPushButton* pause_ = nullptr;
  QPushButton* resume_;
  QPushButton* interviewDone_;
  QPushButton* handOver_;
  QPushButton* consent_;
  QPushButton* close_;
  QLineEdit* note_;
  QListWidget* notes_;
  std::vector<Choice> choices_;
};

}  // namespace study::gui
