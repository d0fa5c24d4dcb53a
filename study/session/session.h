#pragma once

#include <optional>
#include <string>
#include <vector>

#include "questionnaires/model/instrument.h"
#include "study/model/given_answer.h"
#include "study/model/session_plan.h"
#include "study/model/session_state.h"
#include "study/model/trial_record.h"
#include "study/model/user_error.h"
#include "study/session/study.h"
#include "study/storage/lease.h"

namespace study {

/// Who takes part.
struct Enrolment {
  std::string cohort;
  RunMode runMode = RunMode::Live;
  std::string language = "en";
  std::string code;  ///< empty: one is made up
};

/// One sitting of one participant: what may happen next, and every step of it on the disk before
/// anybody sees the next page. The window, the terminal and a simulated cohort go through it alike.
///
/// Whatever returns has been committed. What throws storage::StorageError was not, and nothing has
/// changed: the answers are still on the screen. (Of the kind Unknown, it may have been: the next
/// call finds out, and says so where it was.) The study outlives its sessions.
class Session {
 public:
  /// Reserves the next place of the cohort. The first live participant freezes the protocol.
  /// @throws UserError  if the protocol has no such cohort or language.
  static Session enrol(Study& study, const Enrolment& enrolment);

  /// Goes on with a session at the step it was in. A trial that was under way counts as broken off.
  /// @throws storage::StorageError  (Busy) if another program is running it.
  static Session resume(Study& study, SessionId id);

  SessionId id() const noexcept { return row_.id; }
  const std::string& participant() const noexcept { return row_.participant; }
  RunMode runMode() const noexcept { return row_.runMode; }
  const std::string& cohort() const noexcept { return row_.cohort; }
  std::int64_t slot() const noexcept { return row_.slot; }
  const std::string& language() const noexcept { return row_.language; }
  SessionState state() const noexcept { return row_.state; }
  const std::vector<Step>& plan() const noexcept { return plan_; }
  const protocols::LoadedProtocol& protocol() const noexcept { return *protocol_; }

  bool isOver() const noexcept { return study::isOver(row_.state); }
  bool allows(SessionEvent event) const noexcept;

  /// The step that the participant is in. Not when it is over.
  const Step& step() const { return plan_.at(static_cast<std::size_t>(row_.step)); }
  int stepIndex() const noexcept { return row_.step; }
  VisitKey visit() const noexcept { return {row_.id, row_.step, row_.attempt}; }

  /// What is asked in this step; nothing where nothing is.
  const questionnaires::Instrument* instrument() const;
  std::vector<questionnaires::Item> items() const;
  /// What has been answered in this step so far.
  std::vector<GivenAnswer> answers() const;
  /// The required items that have no answer yet; answers that name a person count as given.
  std::vector<std::string> missing() const;

  /// One answer, or what it was changed to: one transaction.
  /// @throws UserError  if the item is not asked here, or the response cannot be an answer to it.
  void record(const GivenAnswer& answer);

  /// Takes an answer back: the item is missing again.
  void retract(const std::string& item);

  /// The physical cuts that were counted in a benchmark; none or more.
  void recordBenchmarkCuts(int cuts);
  int benchmarkCuts() const;

  /// On to the next step; the consent step leads to consent or to its refusal by what was answered.
  /// @throws UserError  if something required is missing, or this is a trial.
  void finishStep();

  /// Goes on without feeling what is offered once more.
  /// @throws UserError  if nothing is offered in this step.
  void declineOffer();

  void beginTrial();
  /// @param record  of a trial that was finished; any other is broken off.
  void finishTrial(const TrialRecord& record);
  /// No force any more; the operator decides between repeatStep(), skipStep(), giveUpOnDevice().
  void breakOffTrial(const TrialRecord& record);

  /// This step (after a break-off) or the one before it again, from the start; what was answered
  /// stays, marked as repeated.
  void repeatStep(const std::string& reason);
  /// Leaves this step out; of a trial also the questions about it.
  void skipStep(const std::string& reason);
  void pause(const std::string& reason);
  void resumeAfterPause();
  /// At any time, in a trial as well: it is let go of first, and counts as stopped.
  void withdraw(const std::string& reason);
  void reject(const std::string& reason);
  void giveUpOnDevice(const std::string& reason);
  void note(const std::string& text);
  void setLanguage(const std::string& language);

 private:
  Session(Study& study, storage::SessionRow row, std::vector<Step> plan, storage::Lease lease);

  void require(SessionEvent event) const;
  void require(bool condition, const std::string& otherwise) const;
  void transact(const std::function<void()>& action);
  void settleDoubt();
  void say(storage::Actor actor, const std::string& kind, const std::string& detail = {});
  void say(storage::Actor actor, const std::string& kind, base::NamedArguments values);
  void keep(storage::Event event);
  void noticeSteppedClock(const Moment& now);
  std::string utcNow() const;

  /// The parts of a transaction.
  void enter(SessionEvent event, storage::Actor actor, const std::string& detail = {});
  void enter(SessionEvent event, storage::Actor actor, base::NamedArguments values);
  void leaveStep(storage::VisitStatus status, const std::string& reason);
  void moveTo(int step);
  void end(storage::SlotState slot, const std::string& reason);
  void keepTrial(const TrialRecord& record);
  TrialRecord brokenOff(TrialEnding ending);
  int stepToRepeat() const;
  bool isRightAfterConsent() const noexcept;
  bool gaveConsent() const;
  void requireAnswerable() const;
  questionnaires::Item askedItem(const std::string& id) const;
  storage::IdentityStore::Place place() const;
  void storeIdentifying(const questionnaires::Item& item, const GivenAnswer& answer);

  Study& study_;
  storage::SessionRow row_;
  std::vector<Step> plan_;
  const protocols::LoadedProtocol* protocol_;
  storage::Lease lease_;
  std::optional<Moment> lastMoment_;
  std::vector<storage::Event> said_;  ///< in the transaction under way
  bool isInDoubt_ = false;            ///< whether the last transaction arrived
};

/// Whether @p event can happen to a session that is in @p state at step @p step of @p plan: what
/// the state allows, and what this step does.
bool allows(
    SessionState state, const std::vector<Step>& plan, int step, SessionEvent event) noexcept;

/// Whether the step before is one that is never done again.
bool isRightAfterConsent(SessionState state, const std::vector<Step>& plan, int step) noexcept;

}  // namespace study
