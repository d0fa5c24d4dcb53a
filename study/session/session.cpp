#include "study/session/session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/joined.h"
#include "protocols/orders/schedule.h"
#include "questionnaires/json/document.h"
#include "study/session/drawn_plan.h"
#include "study/session/identity_evidence.h"
#include "study/storage/erasure/erasure_repository.h"
#include "study/storage/statement.h"

namespace study {
namespace {

using storage::Actor;
using storage::SessionRow;
using storage::SlotState;
using storage::StorageError;
using storage::VisitStatus;

constexpr double kClockSlack = 2.0;  // [s]: a larger difference is not drift; the wall clock was
                                     // set

[[noreturn]] void refuseDamaged(const std::string& what) {
  throw StorageError(
      what + " Do not go on with it; 'palpate study verify' says more.",
      StorageError::Kind::Damaged);
}

void requireValid(Study& study, const SessionRow& row, const std::vector<Step>& plan) {
  std::vector<std::pair<int, std::string>> drawn;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (!plan[i].condition.empty()) drawn.emplace_back(static_cast<int>(i), plan[i].condition);
  }
  if (storage::allocationOf(study.database(), row.id) != drawn) {
    refuseDamaged("The order of this session is not the one that was drawn for it.");
  }
  const bool isAStep = row.step >= 0 && row.step < static_cast<int>(plan.size());
  if (!isAStep && !isOver(row.state)) refuseDamaged("This session stands before no step.");
}

void requirePossibleEnrolment(const protocols::Protocol& protocol, const Enrolment& enrolment) {
  const auto& languages = protocol.languages;
  if (protocol.cohort(enrolment.cohort) == nullptr) {
    throw UserError("The protocol has no cohort '" + enrolment.cohort + "'.");
  }
  if (std::ranges::find(languages, enrolment.language) == languages.end()) {
    throw UserError(
        "The protocol has no texts in '" + enrolment.language +
        "'. It has: " + base::joined(languages, ", ") + ".");
  }
  if (!enrolment.code.empty() && !questionnaires::isValidId(enrolment.code)) {
    throw UserError(
        "'" + enrolment.code +
        "' cannot be a participant's code. Use letters, digits, '-' and '_'.");
  }
}

/// Freezes the protocol when the first live participant begins.
void freezeProtocolIfFirst(Study& study, const SessionRow& row, const Moment& now) {
  if (row.runMode != RunMode::Live || study.protocols().current().frozenUtc) return;
  study.protocols().freeze(row.protocol, row.startedUtc);
  study.events().append({.when = now, .kind = EventKind::FrozeProtocol, .detail = row.participant});
}

/// @throws UserError  for a collected study, whose sessions can be continued at their stations
///     only.
void requireOwnSessions(const Study& study) {
  if (!study.isCollected()) return;
  throw UserError(
      study.folder().string() +
      " was put together of what several stations sent. Sessions are run at a station; 'palpate "
      "collect pull' brings them here.");
}

/// The participant's code, with the station's label before it, so that stations cannot have equal
/// codes.
std::string codeWithStation(const Station& station, const std::string& code) {
  if (code.empty() || station.isNone() || code.starts_with(station.label + "_")) return code;
  return station.label + "_" + code;
}

/// Draws the keys of a new participant. A participant of an older release gets none until the trail
/// is sealed again, because either all events of a person are sealed or none.
void prepareParticipant(Study& study, const SessionRow& row) {
  if (storage::ErasureRepository(study.database()).hasErasedAnswersOf(row.participant)) {
    throw UserError(
        "'" + row.participant + "' was erased. Choose another code, or leave it to the program.");
  }
  const bool isNew = !study.sessions().hasParticipant(row.participant);
  if (isNew && row.runMode != RunMode::Simulated) study.identities().drawKeys(row.participant);
}

/// The versions of the protocol that draw the same orders as the newest one, among those that this
/// release can read.
std::vector<ProtocolId> versionsOfDesign(Study& study) {
  const auto& newest = study.protocol().protocol;
  std::vector<ProtocolId> versions = study.protocols().all();
  std::erase_if(versions, [&](ProtocolId id) {
    try {
      return !protocols::blocksOrderedOtherwise(study.protocol(id).protocol, newest).empty();
    } catch (const storage::StorageError&) {
      return true;
    }
  });
  return versions;
}

/// Stores a new participant's first session, inside the caller's transaction.
std::vector<Step> addFirstSession(Study& study, SessionRow& row, const Moment& now) {
  auto sessions = study.sessions();
  row.protocol = study.protocols().current().id;
  row.startedUtc = asUtc(now.wall);
  if (row.participant.empty()) row.participant = sessions.freeCode(row.runMode, row.station);
  prepareParticipant(study, row);
  row.slot = sessions.freeSlot(versionsOfDesign(study), row.runMode, row.cohort, row.station);
  auto plan = drawnPlan(study, row);
  freezeProtocolIfFirst(study, row, now);
  sessions.add(row, plan, std::string(appVersion()));
  sessions.openVisit({row.id, 0, 1}, row.startedUtc);
  return plan;
}

/// The time since a session's last event.
struct Pause {
  Moment
      last;  ///< when that event was stored, on clocks that can be compared with the present ones
  /// The pause if the wall clock alone measured it [s]. It is then not known whether that clock
  /// was set forward in between.
  std::optional<double> byWallClockAlone;
};

/// Measured by the monotonic clock if the session continues on the same computer and this was not
/// restarted. Otherwise the pause is the difference of the wall clocks, or 0 if that is negative.
std::optional<Pause> pauseOf(
    Study& study, const SessionRow& row, const std::optional<storage::Lease::Holder>& holder) {
  if (row.runMode == RunMode::Simulated) return std::nullopt;  // its time is simulated
  const auto events = study.events().read(row.id);
  if (events.empty()) return std::nullopt;
  Moment last = events.back().when;
  const Moment now = study.clock().now();
  if (holder && holder->isOfThisBoot && last.monotonic <= now.monotonic) return Pause{last, {}};
  const std::int64_t pause = std::max<std::int64_t>(now.wall - last.wall, 0);  // [ms]
  last.monotonic = now.monotonic - pause * 1'000'000;
  return Pause{last, 1e-3 * static_cast<double>(pause)};
}

}  // namespace

Session::Session(Study& study, SessionRow row, std::vector<Step> plan, storage::Lease lease)
    : study_(study),
      row_(std::move(row)),
      plan_(std::move(plan)),
      protocol_(&study.protocol(row_.protocol)),
      lease_(std::move(lease)) {}

Session Session::enrol(Study& study, const Enrolment& enrolment) {
  requireOwnSessions(study);
  requirePossibleEnrolment(study.protocol().protocol, enrolment);
  SessionRow row;
  std::vector<Step> plan;
  std::optional<storage::Lease> lease;
  study.transact([&] {
    const Moment now = study.clock().now();
    row = {
        .participant = codeWithStation(study.station(), enrolment.code),
        .runMode = enrolment.runMode,
        .cohort = enrolment.cohort,
        .language = enrolment.language,
        .site = study.station().site,
        .station = study.station().label};
    plan = addFirstSession(study, row, now);
    lease.emplace(study.database(), row.id, row.startedUtc);
    study.events().append(
        {.visit = VisitKey{row.id, 0, 1},
         .when = now,
         .kind = EventKind::Enrolled,
         .values = {
             {"participant", row.participant},
             {"cohort", row.cohort},
             {"run_mode", std::string(nameOf(row.runMode))},
             {"place", std::int64_t{row.slot} + 1}}});
  });
  return Session(study, std::move(row), std::move(plan), std::move(*lease));
}

Session Session::resume(Study& study, SessionId id, const std::string& takeOverReason) {
  using From = storage::Lease::From;
  requireOwnSessions(study);
  auto row = study.sessions().load(id);
  const auto holder = storage::Lease::holder(study.database(), id);
  std::optional<storage::Lease> lease;
  study.retryWithReservedSpace([&] {
    storage::Transaction transaction(study.database());
    lease.emplace(
        study.database(),
        id,
        asUtc(study.clock().now().wall),
        takeOverReason.empty() ? From::EndedPrograms : From::OtherComputersToo);
    row = study.sessions().load(id);  // read again: now that the lease is held, no other program
                                      // can change the row
    transaction.commit();
  });
  auto plan = drawnPlan(study, row);
  requireValid(study, row, plan);
  Session session(study, std::move(row), std::move(plan), std::move(*lease));
  if (session.isOver()) return session;
  const auto pause = pauseOf(study, session.row_, holder);
  if (pause) session.lastMoment_ = pause->last;
  session.transact([&] {
    if (holder && holder->isAlive) {
      session.appendEvent(
          Actor::Operator,
          EventKind::TookOver,
          {{"station", holder->station},
           {"process", holder->pid},
           {"since", holder->since},
           {"reason", takeOverReason}});
    }
    base::NamedArguments values;
    if (pause && pause->byWallClockAlone) values = {{"pause_s", *pause->byWallClockAlone}};
    session.appendEvent(Actor::Program, EventKind::Resumed, std::move(values));
  });
  recordIdentityFingerprints(study, session.row_);
  if (session.state() == SessionState::InTrial) {
    session.abortTrial(session.abortedRecord(TrialEnding::ProgramEnded));
  }
  return session;
}

bool Session::isBlinded() const noexcept {
  const auto& protocol = protocol_->protocol;
  return row_.runMode == RunMode::Live && !protocol.isOpenLabel && protocol.conditions.size() > 1;
}

bool Session::allows(SessionEvent event) const noexcept {
  return study::allows(row_.state, plan_, row_.step, event);
}

bool Session::isRightAfterConsent() const noexcept {
  return study::isRightAfterConsent(row_.state, plan_, row_.step);
}

/// Whether the previous step cannot be repeated: there is none, or it is the consent form.
bool isRightAfterConsent(SessionState state, const std::vector<Step>& plan, int step) noexcept {
  const bool isAfterBreakOff = state == SessionState::Interrupted;
  const auto before = static_cast<std::size_t>(step) - 1;
  return !isAfterBreakOff && (step == 0 || plan[before].kind == StepKind::Consent);
}

bool allows(
    SessionState state, const std::vector<Step>& plan, int step, SessionEvent event) noexcept {
  if (!next(state, event) || isOver(state)) return false;
  const auto kind = plan[static_cast<std::size_t>(step)].kind;
  if (event == SessionEvent::BeganTrial || event == SessionEvent::GaveUpOnDevice)
    return kind == StepKind::Trial;
  if (event == SessionEvent::FinishedStep) return kind != StepKind::Trial;
  if (event == SessionEvent::RepeatedStep) return !isRightAfterConsent(state, plan, step);
  if (event == SessionEvent::SkippedStep) return kind != StepKind::Consent;
  return true;
}

void Session::require(SessionEvent event) const {
  require(
      allows(event),
      "'" + std::string(nameOf(event)) + "' cannot happen while the session is '" +
          std::string(nameOf(row_.state)) + "'.");
}

void Session::require(bool condition, const std::string& otherwise) const {
  if (!condition) throw UserError(otherwise);
}

void Session::transact(const std::function<void()>& action) {
  resolveUnknownCommit();
  const SessionRow before = row_;
  const auto lastMoment = lastMoment_;
  try {
    study_.transact([&] {
      // The action runs a second time if the disk was full: both runs must begin with the same
      // state.
      row_ = before;
      lastMoment_ = lastMoment;
      pendingEvents_.clear();
      lease_.requireHeld();
      action();
      study_.sessions().update(row_);
      for (const auto& event : pendingEvents_) study_.events().append(event);
      // Simulated sessions can be reproduced from their seed, so they are not signed one by one.
      const bool isSigned = isOver() && runMode() != RunMode::Simulated && !pendingEvents_.empty();
      if (isSigned) study_.signTrail(pendingEvents_.back().name());
    });
  } catch (const StorageError& error) {
    isCommitUnknown_ = error.kind() == StorageError::Kind::Unknown;
    row_ = before;
    throw;
  } catch (...) {
    row_ = before;
    throw;
  }
}

/// After a commit of unknown outcome: reads the session's row again.
/// @throws UserError  if the commit succeeded, because the caller's step is over.
void Session::resolveUnknownCommit() {
  if (!isCommitUnknown_) return;
  const auto kept = study_.sessions().load(row_.id);
  isCommitUnknown_ = false;
  if (kept == row_) return;
  row_ = kept;
  throw UserError(
      "What could not be confirmed had been kept after all. Go on from the present step.");
}

void Session::appendEvent(Actor actor, EventKind kind, const std::string& detail) {
  addEvent({.actor = actor, .kind = kind, .detail = detail});
}

void Session::appendEvent(Actor actor, EventKind kind, base::NamedArguments values) {
  addEvent({.actor = actor, .kind = kind, .values = std::move(values)});
}

void Session::addEvent(storage::Event event) {
  event.visit = visit();
  event.when = study_.clock().now();
  recordClockStep(event.when);
  pendingEvents_.push_back(std::move(event));
}

void Session::recordClockStep(const Moment& now) {
  const auto last = std::exchange(lastMoment_, now);
  if (!last) return;
  const double byWallClock = static_cast<double>(now.wall - last->wall) / 1e3;        // [s]
  const double elapsed = static_cast<double>(now.monotonic - last->monotonic) / 1e9;  // [s]
  if (std::abs(byWallClock - elapsed) < kClockSlack) return;
  pendingEvents_.push_back(
      {.visit = visit(),
       .when = now,
       .kind = EventKind::ClockStepped,
       .values = {{"by_s", byWallClock - elapsed}}});
}

std::string Session::utcNow() const {
  return asUtc(study_.clock().now().wall);
}

void Session::enter(SessionEvent event, Actor actor, const std::string& detail) {
  row_.state = *next(row_.state, event);
  appendEvent(actor, kindOf(event), detail);
}

void Session::enter(SessionEvent event, Actor actor, base::NamedArguments values) {
  row_.state = *next(row_.state, event);
  appendEvent(actor, kindOf(event), std::move(values));
}

void Session::leaveStep(VisitStatus status, const std::string& reason) {
  study_.sessions().closeVisit(visit(), status, utcNow(), reason);
}

void Session::moveTo(int step) {
  row_.step = step;
  if (step >= static_cast<int>(plan_.size())) {
    enter(SessionEvent::FinishedSession, Actor::Program);
    end(SlotState::Consumed, "completed");
    return;
  }
  row_.attempt = study_.sessions().attempts(row_.id, step) + 1;
  study_.sessions().openVisit(visit(), utcNow());
}

void Session::end(SlotState slot, const std::string& reason) {
  row_.slotState = slot;
  row_.endedUtc = utcNow();
  row_.endReason = reason;
}

}  // namespace study
