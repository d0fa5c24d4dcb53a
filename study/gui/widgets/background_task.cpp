#include "study/gui/widgets/background_task.h"

#include <cmath>
#include <utility>

#include <QVBoxLayout>

#include "study/gui/widgets/attempt.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/labels.h"

namespace study::gui {
namespace {

constexpr int kWatchInterval = 50;  // [ms]
constexpr int kBarSteps = 1000;

}  // namespace

BackgroundTask::BackgroundTask(
    const QString& title, Work work, Cancelling cancelling, QWidget* parent)
    : QDialog(parent),
      words_(bodyLabel(tr("Beginning…"), this)),
      bar_(new QProgressBar(this)),
      cancel_(new QPushButton(tr("Cancel"), this)) {
  setWindowTitle(title);
  setWindowModality(Qt::ApplicationModal);
  setMinimumWidth(520);
  auto* heading = headingLabel(title, this);
  words_->setMinimumHeight(48);
  words_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  bar_->setRange(0, 0);
  bar_->setTextVisible(false);
  bar_->setAccessibleName(title);
  cancel_->setVisible(cancelling == Cancelling::Possible);
  auto* layout = withMargins<QVBoxLayout>(this, {24, 20, 24, 20}, 14);
  layout->addWidget(heading);
  layout->addWidget(words_);
  layout->addWidget(bar_);
  layout->addWidget(cancel_, 0, Qt::AlignRight);
  connect(cancel_, &QPushButton::clicked, this, &BackgroundTask::reject);
  connect(&watch_, &QTimer::timeout, this, &BackgroundTask::showProgress);
  watch_.start(kWatchInterval);
  since_.start();
  worker_.reset(QThread::create([this, work = std::move(work)] {
    std::exception_ptr failure;
    try {
      work([this](double share, const std::string& words) { reportProgress(share, words); });
    } catch (...) {
      failure = std::current_exception();  // shown later by the GUI thread
    }
    const std::lock_guard lock(mutex_);
    failure_ = std::move(failure);
    isOver_ = true;
  }));
  worker_->start();
}

BackgroundTask::~BackgroundTask() {
  {
    const std::lock_guard lock(mutex_);
    isCancelled_ = true;
  }
  worker_->wait();
}

void BackgroundTask::reportProgress(double share, const std::string& words) {
  const std::lock_guard lock(mutex_);
  if (isCancelled_) throw Cancelled();
  share_ = share;
  message_ = words;
}

void BackgroundTask::reject() {
  if (!cancel_->isVisibleTo(this) || !cancel_->isEnabled()) return;
  const std::lock_guard lock(mutex_);
  isCancelled_ = true;
  cancel_->setEnabled(false);
  cancel_->setText(tr("Cancelling…"));
}

/// A line with the time that is left, as far as the share tells it; empty at first.
QString BackgroundTask::timeLeft(double share) const {
  constexpr double kEnoughToTell = 0.05;
  constexpr double kSettling = 3.0;  // [s]
  const double past = 1e-3 * static_cast<double>(since_.elapsed());
  if (share < kEnoughToTell || past < kSettling) return {};
  const auto left = static_cast<int>(std::ceil(past * (1.0 - share) / share));
  constexpr int kMinute = 60;  // [s]
  const auto minutes = tr("About %1 min left.").arg((left + kMinute - 1) / kMinute);
  return u'\n' + (left < kMinute ? tr("Less than a minute left.") : minutes);
}

void BackgroundTask::showProgress() {
  double share = kUnknownShare;
  QString message;
  {
    const std::lock_guard lock(mutex_);
    if (isOver_) {
      watch_.stop();
      done(failure_ ? Rejected : Accepted);
      return;
    }
    share = share_;
    message = deskText(message_);
  }
  if (!message.isEmpty()) words_->setText(capitalised(message) + timeLeft(share));
  bar_->setRange(0, share < 0.0 ? 0 : kBarSteps);
  if (share >= 0.0) bar_->setValue(static_cast<int>(share * kBarSteps));
}

bool BackgroundTask::run(
    QWidget* parent,
    const QString& title,
    MessageTopic failure,
    const Work& work,
    Cancelling cancelling) {
  BackgroundTask task(title, work, cancelling, parent);
  task.exec();
  if (!task.failure()) return true;
  try {
    std::rethrow_exception(task.failure());
  } catch (const Cancelled&) {
    return false;  // cancelled by the user, who needs no message
  } catch (...) {
    return attempt(parent, failure, [&] { std::rethrow_exception(task.failure()); });
  }
}

}  // namespace study::gui
