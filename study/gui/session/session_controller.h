#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include <QDateTime>
#include <QObject>
#include <QString>
#include <QTimer>

#include "study/session/session.h"
#include "study/storage/session_repository.h"
#include "study/trial/live_trial.h"
#include "study/trial/rig.h"
#include "study/trial/trial.h"

namespace study::gui {

namespace scene {
class HipScene;
}

/// One session for the windows: passes what people do on to the session, runs its trials, and tells
/// everybody what has changed. Decides nothing that the session does not allow.
///
/// Slots here do not throw: what failed is told by failed(), and nothing has changed then.
class SessionController final : public QObject {
  Q_OBJECT

 public:
  /// Study and rig outlive it.
  SessionController(Study& study, Rig& rig, Session session, QObject* parent = nullptr);
  ~SessionController() override;

  const Session& session() const noexcept { return session_; }
  Session& session() noexcept { return session_; }
  bool isTrialRunning() const noexcept { return live_ != nullptr; }
  LiveTrial::Status trialStatus() const { return live_ ? live_->status() : LiveTrial::Status{}; }
  /// How the tissue gives way; nothing where the trial is not seen.
  const haptics::engine::MeshView* mesh() const;
  /// What changes in the bone; nothing where nothing does, or the trial is not seen.
  haptics::engine::BoneView* bone() const;
  /// Whom to ask how a trial was seen, when it ends; nobody where it is not.
  void reportViewBy(std::function<std::optional<ViewReport>()> report) {
    viewReport_ = std::move(report);
  }
  /// How the trial is seen; nothing where it is not.
  std::optional<ViewReport> viewReport() const {
    return viewReport_ ? viewReport_() : std::nullopt;
  }
  /// Whom to ask for the cup that the participant sees; nobody where none is seen.
  void showCupBy(std::function<scene::HipScene*()> cup) { cup_ = std::move(cup); }
  scene::HipScene* seenCup() const { return cup_ ? cup_() : nullptr; }
  /// The next sample for a plot.
  bool nextToPlot(haptics::engine::TickSample& sample) {
    return live_ && live_->nextToPlot(sample);
  }
  /// The device that the present trial needs; empty where the step is none.
  QString deviceName() const;
  const haptics::devices::DeviceKind& deviceKind() const;
  double trialRate() const { return trial_ ? trial_->rate() : 0.0; }  ///< [Hz]

  /// How often a step has been begun, and how its last attempt stands.
  int attempts(int step) const;
  storage::VisitStatus statusOf(int step) const;

  /// What the operator has written down in this session, in order.
  struct Note {
    QDateTime when;  ///< local time
    QString text;
  };
  std::vector<Note> notes() const;

  /// Asks whoever shows the step for what was written and not handed on, and keeps it.
  /// @return whether all of it is kept; failed() has said what is not.
  bool keepAll();

 public slots:
  void answer(const study::GivenAnswer& answer);
  void retract(const QString& item);
  void countBenchmarkCut();
  void finishStep();
  /// What is offered once more is not wanted.
  void declineOffer();
  void beginTrial();
  /// Enough was felt.
  void finishTrial();
  /// No force at once.
  void stop();
  void repeatStep(const QString& reason);
  void skipStep(const QString& reason);
  void pause(const QString& reason);
  void resume();
  void withdraw(const QString& reason);
  void reject(const QString& reason);
  void giveUpOnDevice(const QString& reason);
  /// Returns whether it is kept.
  bool note(const QString& text);
  void chooseLanguage(const QString& language);

 signals:
  /// The step is about to be left, or shown in other words: whoever shows it hands on what was
  /// written and has not been yet.
  void aboutToLeave();
  /// An answer, or that it was taken back, could not be kept; failed() has said why.
  void notKept(const QString& item);
  /// Another step, or another state of this one.
  void stepChanged();
  /// While a trial runs: new numbers.
  void trialChanged();
  void languageChanged();
  void failed(const QString& why);

 private:
  void watchTrial();
  void endTrial(TrialEnding ending);
  template <typename Action>
  bool tryTo(Action&& action);
  /// The step goes only when everything that was written in it is kept.
  template <typename Action>
  void leaveBy(Action&& action);
  /// The session goes to its end whatever could not be kept: that was told.
  template <typename Action>
  void endBy(Action&& action);

  Study& study_;
  Rig& rig_;
  Session session_;
  std::optional<storage::TraceStore> traces_;
  std::unique_ptr<Trial> trial_;
  std::unique_ptr<LiveTrial> live_;  // after the trial: goes first
  std::function<std::optional<ViewReport>()> viewReport_;
  std::function<scene::HipScene*()> cup_;
  QTimer watch_;
  bool isAllKept_ = true;  ///< of what was handed on since keepAll() was asked
};

}  // namespace study::gui
