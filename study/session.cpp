#include "study/session.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "protocols/schedule.h"
#include "questionnaires/document.h"
#include "study/storage/transaction.h"

namespace study {
namespace {

using storage::Actor;
using storage::SessionRow;
using storage::SlotState;
using storage::StorageError;
using storage::VisitStatus;

constexpr double kClockSlack = 2.0;  // [s]: more is no drift, somebody set the clock

std::vector<Step> planFor(Study& study, const SessionRow& row) {
  const auto& protocol = study.protocol(row.protocol).protocol;
  return sessionPlan(
      protocol,
      protocols::scheduleFor(
          protocol, study.seed(), row.cohort, static_cast<std::uint64_t>(row.slot)));
}

void requireTheOrderAsDrawn(Study& study, const SessionRow& row, const std::vector<Step>& plan) {
  std::vector<std::pair<int, std::string>> drawn;
  for (std::size_t i = 0; i < plan.size(); ++i) {
    if (!plan[i].condition.empty()) drawn.emplace_back(static_cast<int>(i), plan[i].condition);
  }
  if (study.sessions().allocation(row.id) != drawn) {
    throw StorageError(
        "The order of this session is not the one that was drawn for it. Do not go on with it; "
        "'palpate study verify' says more.",
        StorageError::Kind::Damaged);
  }
}

}  // namespace

Session::Session(Study& study, SessionRow row, std::vector<Step> plan)
    : study_(study),
      row_(std::move(row)),
      plan_(std::move(plan)),
      protocol_(&study.protocol(row_.protocol)),
      lease_(study.database(), row_.id, asUtc(study.clock().now().wall)) {}

Session Session::enrol(Study& study, const Enrolment& enrolment) {
  const auto& protocol = study.protocol().protocol;
  const auto& languages = protocol.languages;
  if (protocol.cohort(enrolment.cohort) == nullptr) {
    throw NotNow("The protocol has no cohort '" + enrolment.cohort + "'.");
  }
  if (std::find(languages.begin(), languages.end(), enrolment.language) == languages.end()) {
    throw NotNow("The protocol has no texts in '" + enrolment.language + "'.");
  }
  if (!enrolment.code.empty() && !questionnaires::isSoundId(enrolment.code)) {
    throw NotNow(
        "'" + enrolment.code +
        "' cannot be a participant's code. Use letters, digits, '-' and '_'.");
  }
  SessionRow row{
      .runMode = enrolment.runMode, .cohort = enrolment.cohort, .language = enrolment.language};
  std::vector<Step> plan;
  study.withRoom([&] {
    storage::Transaction transaction(study.database());
    auto sessions = study.sessions();
    const Moment now = study.clock().now();
    const auto stored = study.protocols().current();
    row.protocol = stored.id;
    row.startedUtc = asUtc(now.wall);
    row.participant = enrolment.code.empty() ? sessions.freeCode(row.runMode) : enrolment.code;
    row.slot = sessions.freeSlot(row.protocol, row.runMode, row.cohort);
    plan = planFor(study, row);
    if (row.runMode == RunMode::Live && !stored.frozenUtc) {
      study.protocols().freeze(stored.id, row.startedUtc);
    }
    sessions.add(row, plan, std::string(appVersion()));
    sessions.openVisit({row.id, 0, 1}, row.startedUtc);
    study.events().append(
        {.visit = VisitKey{row.id, 0, 1},
         .when = now,
         .kind = "enrolled",
         .detail = row.participant + " " + row.cohort + " " + std::string(nameOf(row.runMode)) +
                   ", place " + std::to_string(row.slot + 1)});
    transaction.commit();
  });
  return Session(study, std::move(row), std::move(plan));
}

Session Session::resume(Study& study, SessionId id) {
  auto row = study.sessions().load(id);
  auto plan = planFor(study, row);
  requireTheOrderAsDrawn(study, row, plan);
  Session session(study, std::move(row), std::move(plan));
  if (session.isOver()) return session;
  session.transact([&] { session.say(Actor::Program, "resumed"); });
  if (session.state() == SessionState::InTrial) {
    TrialRecord record{.ending = TrialEnding::ProgramEnded};
    record.traceSamples = study.traces().sampleCount(session.visit());
    record.ticks = record.traceSamples;
    session.breakOffTrial(record);
  }
  return session;
}

bool Session::allows(SessionEvent event) const noexcept {
  if (!next(row_.state, event)) return false;
  if (isOver()) return false;
  const bool isTrial = plan_[static_cast<std::size_t>(row_.step)].kind == StepKind::Trial;
  if (event == SessionEvent::BeganTrial) return isTrial;
  if (event == SessionEvent::FinishedStep) return !isTrial;
  return true;
}

void Session::require(SessionEvent event) const {
  require(
      allows(event),
      "'" + std::string(nameOf(event)) + "' cannot happen while the session is '" +
          std::string(nameOf(row_.state)) + "'.");
}

void Session::require(bool condition, const std::string& otherwise) const {
  if (!condition) throw NotNow(otherwise);
}

void Session::transact(const std::function<void()>& action) {
  const SessionRow before = row_;
  std::vector<std::byte> mark;
  try {
    study_.withRoom([&] {
      row_ = before;
      storage::Transaction transaction(study_.database());
      action();
      study_.sessions().update(row_);
      mark = study_.events().head();
      transaction.commit();
    });
  } catch (const StorageError&) {
    // A commit that failed is unknown, not undone: the audit trail says whether it arrived.
    if (!mark.empty() && study_.events().head() == mark) return;
    row_ = before;
    throw;
  } catch (...) {
    row_ = before;
    throw;
  }
}

void Session::say(Actor actor, const std::string& kind, const std::string& detail) {
  const Moment now = study_.clock().now();
  noticeSteppedClock(now);
  study_.events().append(
      {.visit = visit(), .when = now, .actor = actor, .kind = kind, .detail = detail});
}

void Session::noticeSteppedClock(const Moment& now) {
  const auto last = std::exchange(lastMoment_, now);
  if (!last) return;
  const double onWall = static_cast<double>(now.wall - last->wall) / 1e3;
  const double really = static_cast<double>(now.monotonic - last->monotonic) / 1e9;
  if (std::abs(onWall - really) < kClockSlack) return;
  study_.events().append(
      {.visit = visit(),
       .when = now,
       .kind = "clock_stepped",
       .detail = "by " + std::to_string(onWall - really) + " s; durations are not affected"});
}

std::string Session::utcNow() const {
  return asUtc(study_.clock().now().wall);
}

void Session::enter(SessionEvent event, Actor actor, const std::string& detail) {
  row_.state = *next(row_.state, event);
  say(actor, std::string(nameOf(event)), detail);
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
