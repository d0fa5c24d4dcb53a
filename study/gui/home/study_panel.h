#pragma once

#include <vector>

#include <QFrame>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "study/gui/desk/study_summary.h"

namespace study::gui {

/// One study: title and protocol, the progress of each cohort, the actions on it, its reports and
/// exports, and its unfinished sessions.
class StudyPanel final : public QFrame {
  Q_OBJECT

 public:
  explicit StudyPanel(QWidget* parent = nullptr);

  void show(const StudySummary& summary);
  using QFrame::show;
  /// Shows that no study is selected.
  void clear();
  /// Arranges the buttons group by group in rows that fit into @p width [px].
  void fitInto(int width);

 signals:
  void newStudyRequested();
  void tourRequested();
  void systemCheckRequested();
  void openRequested();
  void resumeSessionRequested(qlonglong session);
  void reportRequested();
  void exportRequested();
  void statisticsRequested();
  void planRequested();
  void simulationRequested();
  void previewRequested();
  void textsRequested();
  void amendmentRequested();
  void backupRequested();
  void verifyRequested();
  void erasureRequested();
  void keyRequested();
  void listRemovalRequested();

 private:
  void makeButtons();
  QWidget* makeStart();
  void showStart(bool isEmpty);
  QWidget* makeRemark(QLabel& remark, const QString& words, void (StudyPanel::*wanted)());
  QHBoxLayout* addRow(QWidget* heading, int headingWidth);
  void enableActions(bool isEnabled);
  void showProgress(const StudySummary& summary);
  void showDocuments(const StudySummary& summary);
  void showUnfinished(const StudySummary& summary);
  void addHeading(const QString& text);
  QWidget* makeCard(const UnfinishedSession& session, bool isMain);

  QLabel* title_;
  QLabel* what_;
  QLabel* sessions_;
  QLabel* arrivals_;
  QLabel* folder_;
  QLabel* keyRemark_;    ///< as long as there is no copy of the key
  QLabel* textsRemark_;  ///< as long as texts are blank
  QLabel* problem_;
  /// Actions that belong together, enabled only if the study can be opened.
  struct Group {
    QLabel* heading = nullptr;
    std::vector<QPushButton*> buttons;
  };
  QVBoxLayout* buttons_;     ///< the groups, row by row
  QVBoxLayout* unfinished_;  ///< cards of sessions, in sight on a small screen
  QPushButton* open_;
  QWidget* start_;  ///< shown in place of the groups if there is no study
  std::vector<Group> groups_;
  QPushButton* removeButton_;
  QWidget* place_;  ///< the progress, documents and unfinished sessions
  QVBoxLayout* parts_;
};

}  // namespace study::gui
