#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <mutex>

#include <QDialog>
#include <QElapsedTimer>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QThread>
#include <QTimer>

#include "study/gui/widgets/messages.h"
#include "study/model/progress.h"

namespace study::gui {

/// Runs work in its own thread behind a dialog with a progress bar, a message and, if possible, a
/// Cancel button. The windows stay responsive.
///
/// The work reports through the Progress that it is given. If it reports no share, the bar only
/// shows activity. After Cancel the next call of Progress throws Cancelled.
class BackgroundTask final : public QDialog {
  Q_OBJECT

 public:
  using Work = std::function<void(const Progress&)>;
  enum class Cancelling { Possible, Impossible };

  /// Shows the dialog and starts the work, whose data must outlive the dialog.
  BackgroundTask(
      const QString& title,
      Work work,
      Cancelling cancelling = Cancelling::Possible,
      QWidget* parent = nullptr);
  /// Cancels the work and waits for its end.
  ~BackgroundTask() override;

  /// Runs @p work behind a dialog. If it fails, shows the message about @p failure with the error's
  /// own.
  /// @return whether it completed: it neither failed nor was cancelled.
  static bool run(
      QWidget* parent,
      const QString& title,
      MessageTopic failure,
      const Work& work,
      Cancelling cancelling = Cancelling::Possible);

  /// The exception that ended the work; nullptr while it runs and if it completed.
  std::exception_ptr failure() const noexcept { return failure_; }

 public slots:
  /// Asks the work to stop. It stops at its next call of Progress.
  void reject() override;

 private:
  void reportProgress(double share, const std::string& words);
  QString timeLeft(double share) const;
  void showProgress();

  QLabel* words_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  QTimer watch_;
  QElapsedTimer since_;
  std::mutex mutex_;  ///< guards the next four members
  double share_ = kUnknownShare;
  std::string message_;
  bool isCancelled_ = false;
  bool isOver_ = false;
  std::exception_ptr failure_;  ///< written by the worker before isOver_ is set
  std::unique_ptr<QThread> worker_;
};

}  // namespace study::gui
