#pragma once

#include <exception>
#include <functional>
#include <memory>
#include <mutex>

#include <QDialog>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QThread>
#include <QTimer>

#include "study/model/progress.h"

namespace study::gui {

/// A piece of work in a thread of its own, while the windows stay alive: how far it is, what it is
/// doing, and a button that cancels it where it can be cancelled.
///
/// The work tells by the Progress that it is given; one that never tells a share has a bar that
/// only moves. Cancelling makes the next call of Progress throw Cancelled.
class BackgroundTask final : public QDialog {
  Q_OBJECT

 public:
  using Work = std::function<void(const Progress&)>;
  enum class Cancelling { Possible, Impossible };

  /// Shows the dialog and begins. What the work uses outlives it.
  BackgroundTask(
      const QString& title,
      Work work,
      Cancelling cancelling = Cancelling::Possible,
      QWidget* parent = nullptr);
  /// Cancels, and waits for the work to end.
  ~BackgroundTask() override;

  /// Runs @p work behind a dialog; if it fails, tells the person at the desk why.
  /// @return whether it came to its end: neither failed nor cancelled.
  static bool run(
      QWidget* parent,
      const QString& title,
      const Work& work,
      Cancelling cancelling = Cancelling::Possible);

  /// Why it did not come to its end; nothing while it runs, and when it did.
  std::exception_ptr failure() const noexcept { return failure_; }

 public slots:
  /// Asks the work to end; it does so at the next place where it can.
  void reject() override;

 private:
  void tellFromWorker(double share, const std::string& words);
  void showHowFar();

  QLabel* words_;
  QProgressBar* bar_;
  QPushButton* cancel_;
  QTimer watch_;
  std::mutex mutex_;  ///< guards the next four
  double share_ = kUnknownShare;
  std::string said_;
  bool isCancelled_ = false;
  bool isOver_ = false;
  std::exception_ptr failure_;  ///< the worker's until it is over
  std::unique_ptr<QThread> worker_;
};

}  // namespace study::gui
