#pragma once

#include <functional>

#include <QComboBox>
#include <QProgressBar>
#include <QPushButton>
#include <QVBoxLayout>
#include <QWidget>

#include "study/gui/session/screen_lock.h"
#include "study/gui/session/session_controller.h"

namespace study::gui {

class TrialPage;
class QuestionnairePage;

/// The participant's window: one page at a time, a progress bar, and a Next button that is enabled
/// when the page is complete. It shows no condition and no other participant's data, and only the
/// operator can close it.
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

  /// Keeps the screen on this window until the operator's PIN is entered.
  ScreenLock& lock() noexcept { return *lock_; }

 protected:
  void closeEvent(QCloseEvent* event) override;
  void changeEvent(QEvent* event) override;

 private:
  void showStep();
  void showPage(QWidget* page);
  void updateProgress();
  void updateTrial();
  void retranslate();

  QWidget* makePage();
  QWidget* makeQuestionnaire();
  QWidget* makeTrialPage();
  QWidget* makeBenchmark();
  QWidget* makeBreak();
  QWidget* makeEnd();
  QWidget* makeMessage(const QString& title, const QString& words);
  QString localized(const questionnaires::LocalizedText& text) const;
  QString alternativeName(const QString& label) const;

  SessionController& controller_;
  std::function<void(double)> moveHand_;
  QProgressBar* progress_;
  QComboBox* languages_;
  QVBoxLayout* place_;
  QPushButton* next_;
  QPushButton* operator_;
  ScreenLock* lock_;
  QWidget* page_ = nullptr;
  TrialPage* trialPage_ = nullptr;
  QuestionnairePage* questions_ = nullptr;
  bool mayClose_ = false;
};

/// The name of a language in that language.
QString nativeName(const QString& language);

}  // namespace study::gui
