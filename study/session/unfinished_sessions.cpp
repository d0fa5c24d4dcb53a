#include "study/session/unfinished_sessions.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "study/session/drawn_plan.h"
#include "study/session/session.h"

namespace study {

const std::string_view kOpenThere =
    "It is open on {} (process {}, since {}): go on there, or close it there first.";
const std::string_view kTakeOver =
    "Take it over with a reason, if that computer is gone or has another name now. It last stored "
    "something at {}.";

namespace {

/// A step as text for the operator, with the label of the alternative instead of its condition.
std::string placeOf(const Step& step, const protocols::Labels& labels) {
  const bool hasLabel = step.kind == StepKind::Trial || step.kind == StepKind::Questionnaire;
  if (!hasLabel) return step.phase;
  const std::string label = labels.nameOf(std::to_string(step.label), "en");
  return step.phase + (step.kind == StepKind::Trial ? ": " : ": questions on ") + label;
}

/// The sentence that offers @p event to the operator in @p state; std::nullopt if the operator
/// cannot choose it.
std::optional<std::string> choiceFor(SessionState state, SessionEvent event) {
  const bool isBroken = state == SessionState::Interrupted;
  switch (event) {
    case SessionEvent::RepeatedStep:
      return isBroken
                 ? "Repeat the trial from its start; what was felt so far is kept as broken off."
                 : "Go back one step and repeat it.";
    case SessionEvent::SkippedStep:
      return isBroken ? "Skip the trial together with its questions."
                      : "Skip the step that it is in.";
    case SessionEvent::GaveUpOnDevice:
      return "Device failed: end it.";
    case SessionEvent::ResumedSession:
      return "End the pause and go on.";
    case SessionEvent::Withdrew:
      return "Participant withdraws: end it because the participant wants to.";
    case SessionEvent::WasRejected:
      return "Reject session: end it for a reason that you give.";
    default:
      return std::nullopt;
  }
}

std::vector<std::string> choicesFor(
    const UnfinishedSession& session, const std::vector<Step>& plan) {
  if (session.isOpenElsewhere()) {
    const auto& holder = *session.holder;
    const auto there =
        fmt::format(fmt::runtime(kOpenThere), holder.station, holder.pid, holder.since);
    if (!session.mayBeTakenOver()) return {there};
    return {there, fmt::format(fmt::runtime(kTakeOver), session.lastStoredUtc)};
  }
  // A trial that was running when its program ended is broken off when the session is resumed.
  const auto found =
      session.state == SessionState::InTrial ? SessionState::Interrupted : session.state;
  std::vector<std::string> choices;
  const auto mayHappen = [&](SessionEvent event) {
    return allows(found, plan, session.step, event);
  };
  if (mayHappen(SessionEvent::FinishedStep) || mayHappen(SessionEvent::BeganTrial)) {
    choices.push_back("Continue in this step; what was answered in it is still there.");
  }
  for (const auto& row : kSessionTransitions) {
    if (row.from != found || !mayHappen(row.event)) continue;
    const auto choice = choiceFor(found, row.event);
    if (choice) choices.push_back(*choice);
  }
  return choices;
}

std::string lastStoredOf(Study& study, const storage::SessionRow& row) {
  const auto events = study.events().read(row.id);
  return events.empty() ? row.startedUtc : asUtc(events.back().when.wall);
}

}  // namespace

std::vector<UnfinishedSession> unfinishedSessions(Study& study) {
  std::vector<UnfinishedSession> unfinished;
  for (const auto& row : study.sessions().all()) {
    if (isOver(row.state)) continue;
    const auto plan = planWithoutConditions(study, row);
    UnfinishedSession session{
        .id = row.id,
        .participant = row.participant,
        .runMode = row.runMode,
        .state = row.state,
        .step = row.step,
        .steps = static_cast<int>(plan.size()),
        .at = plan.at(static_cast<std::size_t>(row.step)),
        .labels = study.protocol(row.protocol).protocol.labels,
        .startedUtc = row.startedUtc,
        .lastStoredUtc = lastStoredOf(study, row),
        .holder = storage::Lease::holder(study.database(), row.id),
        .choices = {}};
    session.choices = choicesFor(session, plan);
    unfinished.push_back(std::move(session));
  }
  return unfinished;
}

int openElsewhereIn(const std::vector<UnfinishedSession>& sessions) noexcept {
  return static_cast<int>(std::ranges::count_if(sessions, &UnfinishedSession::isOpenElsewhere));
}

std::string whatHappened(const UnfinishedSession& session) {
  if (session.isOpenElsewhere()) return "It is open in another window.";
  switch (session.state) {
    case SessionState::Enrolled:
      return session.runMode == RunMode::Live ? "Its place is reserved; consent has not been given."
                                              : "Consent has not been given.";
    case SessionState::InTrial:
      return "The program ended while something was being felt. What was felt until then is kept; "
             "when you go on, the trial counts as broken off, and nothing is felt before you have "
             "decided.";
    case SessionState::Interrupted:
      return "Its trial broke off, and waits for your decision.";
    case SessionState::Paused:
      return "It is paused.";
    default:
      return session.holder ? "The program ended while it was open; every answer that was given is "
                              "kept."
                            : "Its windows were closed; every answer that was given is kept.";
  }
}

std::string describe(const UnfinishedSession& session) {
  const auto begun = session.startedUtc.substr(0, 10) + " " + session.startedUtc.substr(11, 5);
  return session.participant + " (" + std::string(nameOf(session.runMode)) + "), begun " + begun +
         " UTC, is in step " + std::to_string(session.step + 1) + " of " +
         std::to_string(session.steps) + " (" + placeOf(session.at, session.labels) + "). " +
         whatHappened(session);
}

}  // namespace study
