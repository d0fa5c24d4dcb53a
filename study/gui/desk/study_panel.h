#pragma once

#include <vector>

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "study/gui/desk/study_summary.h"

namespace study::gui {

/// One study: what it is, how far each cohort has come, the actions on it, what was written about
/// it, and its unfinished sessions.
class StudyPanel final : public QFrame {
  Q_OBJECT

 public:
  explicit StudyPanel(QWidget* parent = nullptr);

  void show(const StudySummary& summary);
  using QFrame::show;
  /// Shows that no study is selected.
  void clear();
  /// Arranges the buttons in as many columns as fit into @p width [px].
  void fitInto(int width);

 signals:
  void openRequested();
  void goOnRequested(qlonglong session);
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
  void forgetRequested();

 private:
  void makeButtons();
  void showProgress(const StudySummary& summary);
  void showDocuments(const StudySummary& summary);
  void showUnfinished(const StudySummary& summary);
  void addHeading(const QString& text);
  QWidget* makeCard(const UnfinishedSession& session);

  QLabel* title_;
  QLabel* what_;
  QLabel* sessions_;
  QLabel* arrivals_;
  QLabel* folder_;
  QLabel* problem_;
  QGridLayout* buttons_;
  QPushButton* open_;
  std::vector<QPushButton*> actions_;  ///< enabled only if the study can be opened
  QPushButton* texts_ = nullptr;       ///< one of them; says how many texts are blank
  QPushButton* key_ = nullptr;         ///< says if no copy of the key was made
  QPushButton* forget_;
  QWidget* place_;  ///< holds what differs between studies
  QVBoxLayout* parts_;
};

}  // namespace study::gui
