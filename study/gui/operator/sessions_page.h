#pragma once

#include <map>
#include <string>
#include <vector>

#include <QBoxLayout>
#include <QComboBox>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>

#include "study/gui/session/station_push.h"
#include "study/gui/widgets/messages.h"
#include "study/session/session.h"
#include "study/session/unfinished_sessions.h"
#include "study/storage/records.h"

namespace study::gui {

/// The operator's page between sessions: a table of all sessions, details and a resume button for
/// unfinished ones, the remaining participants of each cohort, and a form that enrols a
/// participant.
class SessionsPage final : public QWidget {
  Q_OBJECT

 public:
  /// Study and push must outlive the page.
  SessionsPage(Study& study, StationPush& push, QWidget* parent = nullptr);

  /// Reads the sessions from the database again.
  void refresh();
  /// Offers a pilot first: with virtual devices a live session is probably a mistake.
  void offerPilot();

 signals:
  void enrolRequested(const study::Enrolment& enrolment);
  /// @param takeOver  the reason for taking the session over from a computer that is gone; empty:
  /// no takeover.
  void resumeRequested(qlonglong session, const QString& takeOver);
  void closeRequested();

 protected:
  void hideEvent(QHideEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeList();
  QWidget* makeEnrolment();
  void fillTable(
      const std::vector<storage::SessionRecord>& sessions, const protocols::Protocol& protocol);
  void chooseUsualLanguage();
  void setMinimumHeights();
  void fitColumns();
  void showPush();
  void fillCohorts(
      const std::vector<storage::SessionRecord>& sessions, const protocols::Protocol& protocol);
  void lookElsewhere();
  void showSelected();
  void showNextCode();
  void addAction(QPushButton& button, QLabel& line);
  void resumeSession(const UnfinishedSession& session);
  using End = void (Session::*)(const std::string& reason);
  void endSelected(MessageTopic topic, End end);
  const UnfinishedSession* selectedUnfinished() const;

  Study& study_;
  StationPush& push_;
  QBoxLayout* columns_;
  std::vector<UnfinishedSession> unfinished_;
  QTableWidget* table_;
  int lastOfPeople_ = -1;  ///< row of the latest session that was not simulated; -1: there is none
  QLabel* details_;
  QVBoxLayout* cohortProgress_;  ///< the progress of each cohort
  QComboBox* cohort_;
  QComboBox* mode_;
  QComboBox* language_;
  QGridLayout* actions_;  ///< on the selected session, each with a line beside it
  QLabel* code_;          ///< of the next participant
  QPushButton* enrol_;
  QPushButton* resume_;
  QLabel* resumeLine_;
  struct Ending {
    QPushButton* button;
    QLabel* line;
    SessionEvent event;
  };
  std::vector<Ending> endings_;  ///< end the selected session
  QLabel* arrived_;              ///< how much has arrived at the server; in a station's study only
  QTimer again_;                 ///< looks whether sessions are still open elsewhere
  QPushButton* send_;            ///< sends what has not arrived
};

}  // namespace study::gui
