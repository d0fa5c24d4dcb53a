#pragma once

#include <QFrame>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "study/gui/desk/study_summary.h"

namespace study::gui {

/// One study: what it is, who has taken part, what can be done with it, and what can be done with
/// every session that nobody has ended.
class StudyPanel final : public QFrame {
  Q_OBJECT

 public:
  explicit StudyPanel(QWidget* parent = nullptr);

  void show(const StudySummary& summary);
  using QFrame::show;
  /// No study is chosen.
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
  std::vector<QPushButton*> actions_;  ///< that need a study which can be opened
  QPushButton* forget_;
  QWidget* place_;  ///< of the unfinished sessions
  QVBoxLayout* unfinished_;
};

}  // namespace study::gui
