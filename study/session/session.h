#pragma once

#include <map>
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

/// The participant of a new session.
struct Enrolment {
  std::string cohort;
  RunMode runMode = RunMode::Live;
  std::string language = "en";
  std::string code;  ///< empty: the next free code is used
};

/// One session of one participant: its steps, and the events that are possible next. Every step is
/// on the disk before the next page is shown. The windows, the terminal and simulated sessions all
/// use this class.
///
/// When a function returns, its change has been committed. When it throws storage::StorageError,
/// nothing was committed and nothing has changed: the answers are still on the screen. An error of
/// the kind Unknown is the exception: the commit may have succeeded. The next call then reads the
/// row again, and throws UserError if it did succeed. Functions for which allows() returns false
/// throw UserError. The study must outlive its sessions.
class Session {
 public:
  /// Reserves the next place of the cohort. The first live participant freezes the protocol.
  /// @throws UserError  if the protocol has no such cohort or language.
  static Session enrol(Study& study, const Enrolment& enrolment);

  /// Continues a session at its present step. A trial that was running counts as broken off.
  /// @param takeOverReason  the reason, for the audit trail, to take the session over from another
  ///     computer; empty: the session is not taken over.
  /// @throws storage::StorageError  (Busy) if another program has the session open.
  static Session resume(Study& study, SessionId id, const std::string& takeOverReason = {});

  SessionId id() const noexcept { return row_.id; }
  const std::string& participant() const noexcept { return row_.participant; }
  RunMode runMode() const noexcept { return row_.runMode; }
  const std::string& cohort() const noexcept { return row_.cohort; }
  std::int64_t slot() const noexcept { return row_.slot; }
  const std::string& language() const noexcept { return row_.language; }
  SessionState state() const noexcept { return row_.state; }
  const std::vector<Step>& plan() const noexcept { return plan_; }
  const protocols::LoadedProtocol& protocol() const noexcept { return *protocol_; }

  /// Whether the operator must not know which alternative is which: in a live session of a study
  /// that does not name its conditions.
  bool isBlinded() const noexcept;
  bool isOver() const noexcept { return study::isOver(row_.state); }
  bool allows(SessionEvent event) const noexcept;

  /// The present step. Must not be called when the session is over.
  const Step& step() const { return plan_.at(static_cast<std::size_t>(row_.step)); }
  int stepIndex() const noexcept { return row_.step; }
  /// The step that repeatStep() goes back to.
  int stepToRepeat() const;
  /// The present step and attempt.
  VisitKey visit() const noexcept { return {row_.id, row_.step, row_.attempt}; }

  /// The questionnaire of the present step; nullptr if it has none.
  const questionnaires::Instrument* instrument() const;
  std::vector<questionnaires::Item> items() const;
  /// The labels of the alternatives that the present step offers: those that were felt, or all if
  /// none was. Empty for a step without alternatives.
  std::vector<std::string> alternatives() const;
  /// The answers given in the present step.
  std::vector<GivenAnswer> answers() const;
  /// Whether @p item, one of items(), is asked after the answers given so far (its showIf).
  bool isAsked(const questionnaires::Item& item) const;
  /// The ids of required items that are asked but not answered. An answer that names a person
  /// counts, although it is stored in identity.db.
  std::vector<std::string> missing() const;

  /// Stores a new or a changed answer in one transaction. A name that is typed before the
  /// yes to the consent is stored with that yes.
  /// @throws UserError  if this step does not ask the item, or the response is not valid for it.
  void record(const GivenAnswer& answer);

  /// Deletes the answer to @p item.
  void retract(const std::string& item);

  /// Stores the number of cuts with the physical tool in a benchmark, 0 or more.
  void recordBenchmarkCuts(int cuts);
  int benchmarkCuts() const;

  /// Finishes the present step and moves to the next one. The answers in the consent step decide
  /// between consent and refusal.
  /// @throws UserError  if a required answer is missing, or if the step is a trial.
  void finishStep();

  /// Skips an optional trial (Step::isOptionalTrial). @throws UserError  if the present step is
  /// no optional trial.
  void skipOptionalTrial();

  void beginTrial();
  /// @param record  must have the ending Finished; a trial that ended otherwise goes to
  ///     abortTrial().
  void finishTrial(const TrialRecord& record);
  /// Ends a trial that broke off; its force is off. The operator now chooses between repeatStep(),
  /// skipStep() and giveUpOnDevice().
  void abortTrial(const TrialRecord& record);

  /// After a break-off, repeats the present step; otherwise goes back to the previous one, or from
  /// a questionnaire to its trial. Answers of the earlier attempt are kept and marked as repeated.
  void repeatStep(const std::string& reason);
  /// Skips the present step; if it is a trial, also the questions about it.
  void skipStep(const std::string& reason);
  void pause(const std::string& reason);
  void resumeAfterPause();
  /// The participant withdraws. Possible at any time; a running trial is stopped first.
  void withdraw(const std::string& reason);
  /// The operator rejects the session (SessionState::Rejected). Not possible during a trial.
  void reject(const std::string& reason);
  /// Ends the session because its device cannot be used: before a trial, or after one broke off.
  void giveUpOnDevice(const std::string& reason);
  /// Appends a note of the operator to the audit trail.
  void note(const std::string& text);
  /// Appends to the audit trail that the reamer was switched on or off during a trial.
  void noteReamerSwitch(bool isOn);
  /// Appends to the audit trail that the window shows the operator the forces, or hides them again.
  void noteForcesShown(bool areShown);
  void setLanguage(const std::string& language);

 private:
  Session(Study& study, storage::SessionRow row, std::vector<Step> plan, storage::Lease lease);

  /// @throws UserError  if allows(event) is false.
  void require(SessionEvent event) const;
  /// @throws UserError  with the message @p otherwise, if @p condition is false.
  void require(bool condition, const std::string& otherwise) const;
  /// Runs @p action in a transaction that also stores the row and the pending events.
  void transact(const std::function<void()>& action);
  void resolveUnknownCommit();
  void appendEvent(storage::Actor actor, EventKind kind, const std::string& detail = {});
  void appendEvent(storage::Actor actor, EventKind kind, base::NamedArguments values);
  /// Adds an event to the present transaction.
  void addEvent(storage::Event event);
  /// Adds an event ClockStepped if the wall clock was set since the last event.
  void recordClockStep(const Moment& now);
  std::string utcNow() const;

  /// The functions below run inside a transaction.
  void enter(SessionEvent event, storage::Actor actor, const std::string& detail = {});
  void enter(SessionEvent event, storage::Actor actor, base::NamedArguments values);
  /// Closes the present visit.
  void leaveStep(storage::VisitStatus status, const std::string& reason);
  /// Opens a visit to @p step; after the last step, ends the session.
  void moveTo(int step);
  /// Ends the session; @p slot becomes the state of its place in the design.
  void end(storage::SlotState slot, const std::string& reason);
  /// Stores a trial and its events.
  void keepTrial(const TrialRecord& record);
  TrialRecord abortedRecord(TrialEnding ending);
  bool isRightAfterConsent() const noexcept;
  bool gaveConsent() const;
  /// @throws UserError  if nothing can be answered in the present state.
  void requireAnswerable() const;
  /// The item of the present step with this id. @throws UserError  if the step does not ask it.
  questionnaires::Item askedItem(const std::string& id) const;
  /// Where answers that name a person are stored in identity.db.
  storage::IdentityStore::Place place() const;
  /// Stores an answer that names a person. In the consent step it is only held until the
  /// participant says yes.
  void storeIdentifying(const questionnaires::Item& item, const GivenAnswer& answer);
  /// Stores a name in identity.db, and its fingerprint in the audit trail.
  void storeName(const std::string& item, const std::string& text);
  /// Stores the held names, if the answers given so far consent.
  void storeHeldNames();

  Study& study_;
  storage::SessionRow row_;
  std::vector<Step> plan_;
  const protocols::LoadedProtocol* protocol_;
  storage::Lease lease_;
  std::optional<Moment> lastMoment_;
  std::map<std::string, std::string> heldNames_;  ///< by item; typed before a yes to the consent
  std::vector<storage::Event> pendingEvents_;     ///< events of the present transaction
  bool isCommitUnknown_ = false;  ///< whether the outcome of the last commit is unknown
};

/// Whether @p event is possible for a session in @p state at step @p step of @p plan; depends on
/// the state and on the kind of the step.
bool allows(
    SessionState state, const std::vector<Step>& plan, int step, SessionEvent event) noexcept;

/// Whether repeatStep() cannot go back: there is no previous step, or it is the consent form.
bool isRightAfterConsent(SessionState state, const std::vector<Step>& plan, int step) noexcept;

}  // namespace study
