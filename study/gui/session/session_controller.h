#pragma once

#include <memory>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QObject>
#include <QPointer>
#include <QString>
#include <QTimer>

#include "study/session/session.h"
#include "study/storage/session_repository.h"
#include "study/trial/device_set.h"
#include "study/trial/live_trial.h"
#include "study/trial/trial.h"

namespace study::gui {

namespace scene {
class HipScene;
class SimulationView;
}  // namespace scene

/// The link between one session and the windows. It passes user actions to the session, runs its
/// trials, and emits signals on changes. What is allowed is decided by the session.
///
/// Slots do not throw. If one fails, it emits failed() and changes nothing.
class SessionController final : public QObject {
  Q_OBJECT

 public:
  /// Study and device set must outlive the controller.
  SessionController(Study& study, DeviceSet& deviceSet, Session session, QObject* parent = nullptr);
  ~SessionController() override;

  const Session& session() const noexcept { return session_; }
  Session& session() noexcept { return session_; }
  bool isTrialRunning() const noexcept { return liveTrial_ != nullptr; }
  /// Whether a trial has ended and could not be saved; saveTrial() tries again.
  bool isTrialUnsaved() const noexcept {
    return !isTrialRunning() && session_.state() == SessionState::InTrial;
  }
  /// Whether the participant can do nothing until the operator goes on.
  bool isWaiting() const noexcept {
    const auto state = session_.state();
    return state == SessionState::Paused || state == SessionState::Interrupted || isTrialUnsaved();
  }
  /// Whether the disk may be too full for the next trial.
  bool isDiskAlmostFull() const;
  LiveTrial::Status trialStatus() const {
    return liveTrial_ ? liveTrial_->status() : LiveTrial::Status{};
  }
  /// How the tissue deforms; nullptr if the trial is not visualised.
  const haptics::engine::MeshView* mesh() const;
  /// The changes of the bone; nullptr if there are none or the trial is not visualised.
  haptics::engine::BoneView* bone() const;
  /// Sets the view of the trial; null: the trial is not visualised.
  void setView(QPointer<scene::SimulationView> view) { view_ = std::move(view); }
  /// The frame statistics of the trial; std::nullopt if it is not visualised.
  std::optional<ViewReport> viewReport() const;
  /// The bone shown to the participant; nullptr if no bone is shown.
  scene::HipScene* visibleHipScene() const;
  /// Takes the next sample for a plot.
  /// @return false if there is no further sample.
  bool nextToPlot(haptics::engine::TickSample& sample) {
    return liveTrial_ && liveTrial_->nextToPlot(sample);
  }
  /// The id of the device that the current trial needs; empty in other steps.
  QString deviceName() const;
  const haptics::devices::DeviceKind& deviceKind() const;
  /// Whether the device of the current trial is open and virtual: the page moves it.
  bool isDeviceVirtual() const;
  double trialRate() const { return trial_ ? trial_->rate() : 0.0; }  ///< [Hz]

  /// The number of attempts at a step, and the status of the last one.
  int attempts(int step) const;
  storage::VisitStatus statusOf(int step) const;

  /// A note that the operator wrote.
  struct Note {
    QDateTime when;  ///< local time
    QString text;
  };
  std::vector<Note> notes() const;

  /// Saves an unsaved trial, and the answers that the page of the current step still holds.
  /// @return whether all were saved; failed() was emitted for each that was not.
  bool savePending();

 public slots:
  void answer(const study::GivenAnswer& answer);
  void retract(const QString& item);
  /// Counts cuts with the physical tool; in other steps than a benchmark it does nothing.
  /// @param by  1, or −1 if one was counted too many
  void changeBenchmarkCuts(int by);
  void finishStep();
  /// Skips the optional repetition of a trial.
  void skipOptionalTrial();
  void beginTrial();
  /// Ends the trial if the participant has made enough cuts.
  void finishTrial();
  /// Switches the reamer of a running trial on or off, and notes it; on at first.
  void toggleReamer();
  /// Switches the force off at once and breaks the trial off.
  void stop();
  /// Saves a trial that has ended. If that fails, the trial stays unsaved.
  /// @return whether no trial is unsaved any more.
  bool saveTrial();
  void repeatStep(const QString& reason);
  void skipStep(const QString& reason);
  void pause(const QString& reason);
  void resume();
  void withdraw(const QString& reason);
  void reject(const QString& reason);
  void giveUpOnDevice(const QString& reason);
  /// Saves a note.
  /// @return whether it was saved.
  bool note(const QString& text);
  /// Notes that the window shows the operator the forces, or hides them again.
  /// @return whether it was noted.
  bool noteForcesShown(bool areShown);
  void chooseLanguage(const QString& language);

 signals:
  /// Emitted before the step is left or the language changes. The page of the step then emits its
  /// unsaved answers.
  void aboutToLeave();
  /// An answer or its removal could not be saved. failed() has given the reason.
  void notSaved(const QString& item);
  void benchmarkCutsChanged();
  /// The step or its state changed.
  void stepChanged();
  /// Emitted while a trial runs: there are new samples.
  void trialChanged();
  void languageChanged();
  void failed(const QString& why);

 private:
  void watchTrial();
  void endTrial(TrialEnding ending);
  template <typename Action>
  bool tryTo(Action&& action);
  /// Runs @p action, which leaves the step, only if all answers were saved.
  template <typename Action>
  void leaveStep(Action&& action);
  /// Runs @p action, which ends the session, even if an answer could not be saved; failed() was
  /// emitted then.
  template <typename Action>
  void endSession(Action&& action);

  Study& study_;
  DeviceSet& deviceSet_;
  Session session_;
  std::optional<storage::TraceStore> traces_;
  std::unique_ptr<Trial> trial_;
  std::unique_ptr<LiveTrial> liveTrial_;  // declared after the trial, so that it is destroyed first
  std::optional<TrialRecord> unsaved_;    ///< of the trial that has ended, until it is saved
  QPointer<scene::SimulationView> view_;
  QTimer watch_;
  bool isReamerOn_ = true;  ///< of the running trial, by toggleReamer()
  bool isAllSaved_ = true;  ///< since the last savePending()
};

}  // namespace study::gui
