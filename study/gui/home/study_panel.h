#pragma once

#include <vector>

#include <QFrame>
#include <QGridLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "study/gui/desk/study_summary.h"

namespace study::gui {

/// One study: its progress by cohort, what is to be done next, the other actions on it, and the
/// reports and exports that were written of it. It is as high as its contents.
class StudyPanel final : public QFrame {
  Q_OBJECT

 public:
  explicit StudyPanel(QWidget* parent = nullptr);

  void show(const StudySummary& summary);
  using QFrame::show;
  /// Shows that no study is selected.
  void clear();
  /// Arranges the groups of actions in as many columns as fit into @p width [px].
  void fitInto(int width);

 signals:
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

 protected:
  bool event(QEvent* event) override;

 private:
  void setMinimumHeights();
  QWidget* makeRemark(QLabel& remark, const QString& words, void (StudyPanel::*requestSignal)());
  void makeActions();
  QFrame* makeSeparator();
  void enableActions(bool isEnabled);
  void showUnfinished(const StudySummary& summary);
  void showProgress(const StudySummary& summary);
  void showDocuments(const StudySummary& summary);
  QWidget* makeCard(const UnfinishedSession& session, bool isMain);

  QLabel* title_;
  QLabel* sessions_;
  QLabel* arrivals_;
  QLabel* keyRemark_;    ///< as long as there is no copy of the key
  QLabel* textsRemark_;  ///< as long as texts are blank
  QLabel* problem_;
  QVBoxLayout* progress_;    ///< of each cohort
  QVBoxLayout* unfinished_;  ///< cards of sessions
  QPushButton* open_;
  /// Actions that belong together, enabled only if the study can be opened.
  struct Group {
    QWidget* column = nullptr;  ///< a heading, and the buttons below it
    std::vector<QPushButton*> buttons;
  };
  std::vector<Group> groups_;
  QGridLayout* actions_;  ///< the groups
  QPushButton* removeButton_;
  QWidget* documents_;  ///< reports and exports
  QVBoxLayout* documentRows_;
  QLabel* blindingRemark_;  ///< as long as a document may tell conditions to who runs sessions
  QLabel* foot_;            ///< the protocol and the folder
};

}  // namespace study::gui
