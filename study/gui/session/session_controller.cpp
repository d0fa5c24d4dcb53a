#include "study/gui/session/session_controller.h"

#include <exception>
#include <utility>

#include "study/gui/scene/hip_scene.h"
#include "study/gui/scene/simulation_view.h"
#include "study/gui/widgets/desk_language.h"
#include "study/session/trial_setup.h"
#include "study/storage/local_disk.h"

namespace study::gui {
namespace {
constexpr int kRefreshInterval = 16;  // [ms]: about sixty times a second
}

SessionController::SessionController(
    Study& study, DeviceSet& deviceSet, Session session, QObject* parent)
    : QObject(parent), study_(study), deviceSet_(deviceSet), session_(std::move(session)) {
  watch_.setInterval(kRefreshInterval);
  connect(&watch_, &QTimer::timeout, this, &SessionController::watchTrial);
}

SessionController::~SessionController() {
  if (liveTrial_) endTrial(TrialEnding::ProgramEnded);
}

template <typename Action>
bool SessionController::tryTo(Action&& action) {
  try {
    action();
    return true;
  } catch (const std::exception& error) {
    emit failed(deskText(error));
    return false;
  }
}

bool SessionController::savePending() {
  isAllSaved_ = saveTrial();
  emit aboutToLeave();
  return isAllSaved_;
}

template <typename Action>
void SessionController::leaveStep(Action&& action) {
  if (savePending() && tryTo(std::forward<Action>(action))) emit stepChanged();
}

template <typename Action>
void SessionController::endSession(Action&& action) {
  savePending();
  if (tryTo(std::forward<Action>(action))) emit stepChanged();
}

const haptics::engine::MeshView* SessionController::mesh() const {
  return trial_ ? trial_->scene().mesh() : nullptr;
}

haptics::engine::BoneView* SessionController::bone() const {
  return trial_ ? trial_->scene().bone() : nullptr;
}

QString SessionController::deviceName() const {
  if (session_.isOver() || session_.step().kind != StepKind::Trial) return {};
  return QString::fromStdString(deviceFor(session_).id);
}

const haptics::devices::DeviceKind& SessionController::deviceKind() const {
  return *deviceFor(session_).kind;
}

bool SessionController::isDeviceVirtual() const {
  if (deviceName().isEmpty()) return false;
  const auto& need = deviceFor(session_);
  return deviceSet_.isOpen(need.id) && deviceSet_.device(need).capabilities().isSimulated;
}

int SessionController::attempts(int step) const {
  return study_.sessions().attempts(session_.id(), step);
}

storage::VisitStatus SessionController::statusOf(int step) const {
  return study_.sessions().statusOf({session_.id(), step, attempts(step)});
}

void SessionController::answer(const study::GivenAnswer& answer) {
  if (tryTo([&] { session_.record(answer); })) return;
  isAllSaved_ = false;
  emit notSaved(QString::fromStdString(answer.item));
}

void SessionController::retract(const QString& item) {
  if (tryTo([&] { session_.retract(item.toStdString()); })) return;
  isAllSaved_ = false;
  emit notSaved(item);
}

void SessionController::changeBenchmarkCuts(int by) {
  if (session_.isOver() || session_.step().kind != StepKind::Benchmark) return;
  const int cuts = session_.benchmarkCuts() + by;
  if (cuts >= 0 && tryTo([&] { session_.recordBenchmarkCuts(cuts); })) emit benchmarkCutsChanged();
}

void SessionController::finishStep() {
  leaveStep([&] { session_.finishStep(); });
}

void SessionController::skipOptionalTrial() {
  leaveStep([&] { session_.skipOptionalTrial(); });
}

void SessionController::beginTrial() {
  if (liveTrial_) return;
  const bool isRunning = tryTo([&] {
    traces_.emplace(study_.openTraces());
    trial_ = trialFor(session_, deviceSet_, *traces_);
    session_.beginTrial();
    liveTrial_ = std::make_unique<LiveTrial>(*trial_);
  });
  if (!isRunning) {
    trial_.reset();
    saveTrial();
    return;
  }
  isReamerOn_ = true;
  watch_.start();
  emit stepChanged();
}

void SessionController::toggleReamer() {
  if (!liveTrial_) return;
  isReamerOn_ = !isReamerOn_;
  trial_->switchReamer(isReamerOn_);  // before the database is written: a pedal acts at once
  tryTo([&] { session_.noteReamerSwitch(isReamerOn_); });
}

void SessionController::watchTrial() {
  if (!liveTrial_) return;
  const auto status = liveTrial_->status();
  if (status.isDeviceGone) {
    endTrial(TrialEnding::DeviceGone);
  } else if (status.isTraceLost) {
    endTrial(TrialEnding::TraceLost);
  } else {
    emit trialChanged();
  }
}

std::optional<ViewReport> SessionController::viewReport() const {
  return view_.isNull() ? std::nullopt : std::optional(view_->report());
}

scene::HipScene* SessionController::visibleHipScene() const {
  return view_.isNull() ? nullptr : dynamic_cast<scene::HipScene*>(&view_->scene());
}

void SessionController::finishTrial() {
  if (liveTrial_ && liveTrial_->status().cuts >= session_.step().minimumCuts)
    endTrial(TrialEnding::Finished);
}

void SessionController::stop() {
  if (!liveTrial_) return;
  liveTrial_->stop();
  endTrial(TrialEnding::Stopped);
}

void SessionController::endTrial(TrialEnding ending) {
  watch_.stop();
  unsaved_ = liveTrial_->finish(ending);
  unsaved_->view = viewReport();
  liveTrial_.reset();
  trial_.reset();
  saveTrial();
}

bool SessionController::saveTrial() {
  if (!isTrialUnsaved()) return true;
  // Without a record, the trial failed to begin.
  const auto record = unsaved_.value_or(TrialRecord{.ending = TrialEnding::TraceLost});
  QString why;
  try {
    if (record.ending == TrialEnding::Finished) {
      session_.finishTrial(record);
    } else {
      session_.abortTrial(record);
    }
  } catch (const std::exception& error) {
    why = deskText(error);
  }
  if (!isTrialUnsaved()) unsaved_.reset();
  emit stepChanged();  // first: the message waits for its reader
  if (!why.isEmpty()) emit failed(why);
  return !isTrialUnsaved();
}

bool SessionController::isDiskAlmostFull() const {
  return storage::ReservedSpace(study_.folder()).isDiskAlmostFull();
}

void SessionController::repeatStep(const QString& reason) {
  leaveStep([&] { session_.repeatStep(reason.toStdString()); });
}

void SessionController::skipStep(const QString& reason) {
  leaveStep([&] { session_.skipStep(reason.toStdString()); });
}

void SessionController::pause(const QString& reason) {
  leaveStep([&] { session_.pause(reason.toStdString()); });
}

void SessionController::resume() {
  if (tryTo([&] { session_.resumeAfterPause(); })) emit stepChanged();
}

void SessionController::withdraw(const QString& reason) {
  if (liveTrial_) stop();
  endSession([&] { session_.withdraw(reason.toStdString()); });
}

void SessionController::reject(const QString& reason) {
  endSession([&] { session_.reject(reason.toStdString()); });
}

void SessionController::giveUpOnDevice(const QString& reason) {
  endSession([&] { session_.giveUpOnDevice(reason.toStdString()); });
}

std::vector<SessionController::Note> SessionController::notes() const {
  std::vector<Note> notes;
  for (const auto& event : study_.events().read(session_.id())) {
    if (event.kind != EventKind::Note) continue;
    notes.push_back(
        {QDateTime::fromMSecsSinceEpoch(event.when.wall), QString::fromStdString(event.detail)});
  }
  return notes;
}

bool SessionController::note(const QString& text) {
  return tryTo([&] { session_.note(text.toStdString()); });
}

bool SessionController::noteForcesShown(bool areShown) {
  return tryTo([&] { session_.noteForcesShown(areShown); });
}

void SessionController::chooseLanguage(const QString& language) {
  if (savePending() && tryTo([&] { session_.setLanguage(language.toStdString()); }))
    emit languageChanged();
}

}  // namespace study::gui
