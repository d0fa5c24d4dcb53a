#pragma once

#include <functional>

#include <QComboBox>
#include <QFrame>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>
#include <QWidget>

#include "study/gui/session/screen_lock.h"
#include "study/gui/session/session_controller.h"

namespace study::gui {

class TrialPage;
class QuestionnairePage;

/// The participant's window: one page at a time, a progress bar, and a Next button that shows the
/// unanswered questions if the page is not complete. Its text grows with the window, so that it can
/// be read on a large second screen. It shows no condition and no other participant's data, and
/// only the operator can close it.
class ParticipantWindow final : public QWidget {
  Q_OBJECT

 public:
  /// @param pin  unlocks the window; must outlive it.
  /// @param moveHand  called with the hand position of a virtual device, 0 (open) … 1 (closed).
  ParticipantWindow(
      SessionController& controller,
      OperatorPin& pin,
      std::function<void(double)> moveHand,
      QWidget* parent = nullptr);

  /// Called when the operator closes the session. Before this call the window refuses to close.
  void allowClosing() { mayClose_ = true; }

  /// Shows the pages as on a screen of this size, smaller or larger by the ratio of the widths; an
  /// empty size: as the window's own.
  void showAsOn(QSize screen);

  /// The lock that keeps the screen on this window until the operator's PIN is entered.
  ScreenLock& lock() noexcept { return *lock_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;
  void resizeEvent(QResizeEvent* event) override;

 private:
  void showStep();
  void showPage(QWidget* page);
  void goOn();
  void goBack();
  bool mayReadAgain() const;
  void readAgain();
  void stopReadingAgain();
  void ignorePresses();
  void takePresses(bool isTaking);
  void showUnanswered(bool isAskedFor);
  void updateProgress();
  void updateTrial();
  void retranslate();

  QWidget* makePage();
  QWidget* makeQuestionnaire();
  QWidget* makeTrialPage();
  QWidget* makeBenchmark();
  QWidget* makeBreak();
  QWidget* makeEnd();
  QWidget* makeThanks(const QString& title, const QString& now);
  QWidget* makeMessage(const QString& title, const QString& words);
  void adjustScale();
  QString localized(const questionnaires::LocalizedText& text) const;
  QString alternativeName(const QString& label) const;
  QString alternativeTitle() const;
  QStringList whereInSession() const;

  SessionController& controller_;
  std::function<void(double)> moveHand_;
  QProgressBar* progress_;
  QLabel* stepLabel_;  ///< beside it: "Round 1 of 2 · Trial 1 of 3", or "Step 4 of 19"
  QComboBox* languages_;
  QVBoxLayout* rows_;  ///< of the window
  QVBoxLayout* place_;
  QFrame* foldLine_;  ///< a line below a page that goes on below
  QWidget* bottom_;   ///< with the buttons
  QLabel* remark_;    ///< beside Next: what is left to do on this page
  QPushButton* back_;
  QPushButton* next_;
  QPushButton* operator_;
  ScreenLock* lock_;
  QTimer* newPageTimer_;  ///< while it runs, presses are ignored
  QWidget* page_ = nullptr;
  QWidget* readAgainPage_ =
      nullptr;  ///< the text before the step, while it is read again over the page
  TrialPage* trialPage_ = nullptr;
  QuestionnairePage* questions_ = nullptr;
  QSize screen_;  ///< as on which the pages are shown; empty: the window's own
  double scale_ = 0.0;
  bool showsUnanswered_ = false;  ///< true once Next was pressed on an incomplete page
  bool mayClose_ = false;
};

}  // namespace study::gui
