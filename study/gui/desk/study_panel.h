#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "study/gui/desk/study_summary.h"

namespace study::gui {

/// One study: what it is, who has taken part, the actions on it, and the actions on each unfinished
/// session.
class StudyPanel final : public QFrame {
  Q_OBJECT

 public:
  explicit StudyPanel(QWidget* parent = nullptr);

  void show(const StudySummary& summary);
  using QFrame::show;
  /// Shows that no study is selected.
  void clear();

 signals:
  void openRequested();
  void goOnRequested(qlonglong session);
  void backupRequested();
  void verifyRequested();
  void reportRequested();
  void exportRequested();
  void forgetRequested();

 private:
  void showUnfinished(const StudySummary& summary);
  QWidget* cardOf(const UnfinishedSession& session);

  QLabel* title_;
  QLabel* what_;
  QLabel* sessions_;
  QLabel* folder_;
  QLabel* problem_;
  QPushButton* open_;
  std::vector<QPushButton*> actions_;  ///< enabled only if the study can be opened
  QPushButton* forget_;
  QWidget* place_;  ///< holds the unfinished sessions
  QVBoxLayout* unfinished_;
};

}  // namespace study::gui
