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

/// What a participant sees: one page at a time, how far they are, and a button that goes on when
/// the page is complete. Names no condition, shows nobody else's data, and does not close by
/// itself.
class ParticipantWindow final : public QWidget {
  Q_OBJECT

 public:
  /// @param pin  what opens the window when it is locked; outlives it.
  /// @param moveHand  where the pointer hand of a virtual instrument goes, 0 (open) … 1 (closed).
  ParticipantWindow(
      SessionController& controller,
      OperatorPin& pin,
      std::function<void(double)> moveHand,
      QWidget* parent = nullptr);

  /// The operator closes the session; only then does this window close.
  void allowClosing() { mayClose_ = true; }

  /// The screen is the participant's until the operator's PIN.
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
  TrialPage* feel_ = nullptr;
  QuestionnairePage* questions_ = nullptr;
  bool mayClose_ = false;
};

/// What a language is called by those who speak it.
QString nativeName(const QString& language);

}  // namespace study::gui
