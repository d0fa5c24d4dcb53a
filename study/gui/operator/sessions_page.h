#pragma once

#include <map>
#include <string>
#include <vector>

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <QWidget>

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
  /// The study must outlive the page.
  explicit SessionsPage(Study& study, QWidget* parent = nullptr);

  /// Reads the sessions from the database again.
  void refresh();

 signals:
  void enrolRequested(const study::Enrolment& enrolment);
  /// @param takeOver  why it is taken from a computer that is gone; empty: it is not.
  void resumeRequested(qlonglong session, const QString& takeOver);

 protected:
  void resizeEvent(QResizeEvent* event) override;

 private:
  QWidget* makeList();
  QWidget* makeEnrolment();
  void fillTable(
      const std::vector<storage::SessionRecord>& sessions, const protocols::Protocol& protocol);
  void giveRoom();
  void fillCohorts(
      const std::vector<storage::SessionRecord>& sessions, const protocols::Protocol& protocol);
  void showSelected();
  void goOnWith(const UnfinishedSession& session);
  const UnfinishedSession* selectedUnfinished() const;

  Study& study_;
  QBoxLayout* columns_;
  std::vector<UnfinishedSession> unfinished_;
  QTableWidget* table_;
  QLabel* details_;
  QVBoxLayout* coming_;  ///< how far each cohort has come
  QComboBox* cohort_;
  QComboBox* mode_;
  QComboBox* language_;
  QPushButton* enrol_;
  QPushButton* resume_;
};

}  // namespace study::gui
