// How a session goes on: steps, trials, and what the operator may decide.
#include <algorithm>

#include "study/session.h"
#include "study/storage/trial_repository.h"

namespace study {

using storage::Actor;
using storage::SlotState;
using storage::VisitStatus;

void Session::finishStep() {
  require(SessionEvent::FinishedStep);
  const auto open = missing();
  require(
      open.empty(), "Not everything is answered yet: " + (open.empty() ? "" : open.front()) + ".");
  const auto& present = step();
  if (present.kind == StepKind::Benchmark) {
    require(
        benchmarkCuts() >= present.minimumCuts,
        "At least " + std::to_string(present.minimumCuts) + " cuts are needed first.");
  }
  transact([&] {
    const bool isConsent = present.kind == StepKind::Consent;
    if (isConsent && !gaveConsent()) {
      leaveStep(VisitStatus::Finished, "");
      enter(SessionEvent::DeclinedConsent, Actor::Participant);
      end(SlotState::Released, "declined");
      return;
    }
    leaveStep(VisitStatus::Finished, "");
    enter(
        isConsent ? SessionEvent::GaveConsent : SessionEvent::FinishedStep,
        Actor::Participant,
        present.phase);
    moveTo(row_.step + 1);
  });
}

void Session::beginTrial() {
  require(SessionEvent::BeganTrial);
  transact([&] { enter(SessionEvent::BeganTrial, Actor::Program); });
}

void Session::finishTrial(const TrialRecord& record) {
  require(SessionEvent::FinishedTrial);
  transact([&] {
    storage::TrialRepository(study_.database()).add(visit(), record);
    leaveStep(VisitStatus::Finished, "");
    enter(
        SessionEvent::FinishedTrial,
        Actor::Program,
        std::to_string(record.cuts.size()) + " cuts, " +
            std::string(nameOf(record.judgement().verdict)));
    moveTo(row_.step + 1);
  });
}

void Session::breakOffTrial(const TrialRecord& record) {
  require(SessionEvent::BrokeOffTrial);
  transact([&] {
    storage::TrialRepository(study_.database()).add(visit(), record);
    leaveStep(VisitStatus::BrokenOff, std::string(nameOf(record.ending)));
    enter(SessionEvent::BrokeOffTrial, Actor::Program, std::string(nameOf(record.ending)));
  });
}

void Session::repeatStep(const std::string& reason) {
  require(SessionEvent::RepeatedStep);
  int target = row_.step;
  if (row_.state != SessionState::Interrupted) {
    if (step().kind == StepKind::Questionnaire) {
      while (plan_[static_cast<std::size_t>(target)].kind != StepKind::Trial) --target;
    } else if (target > 0) {
      --target;
    }
    const bool isConsent = plan_[static_cast<std::size_t>(target)].kind == StepKind::Consent;
    require(!isConsent, "Consent was given; that step is not repeated.");
  }
  transact([&] {
    study_.sessions().markRepeated(row_.id, target, utcNow(), reason);
    enter(SessionEvent::RepeatedStep, Actor::Operator, reason);
    moveTo(target);
  });
}

void Session::skipStep(const std::string& reason) {
  require(SessionEvent::SkippedStep);
  require(step().kind != StepKind::Consent, "Consent is not skipped.");
  transact([&] {
    const Step skipped = step();
    auto sessions = study_.sessions();
    if (row_.state != SessionState::Interrupted) leaveStep(VisitStatus::Skipped, reason);
    enter(SessionEvent::SkippedStep, Actor::Operator, reason);
    int target = row_.step + 1;
    // Nobody is asked about what nobody felt.
    while (skipped.kind == StepKind::Trial && target < static_cast<int>(plan_.size()) &&
           plan_[static_cast<std::size_t>(target)].kind == StepKind::Questionnaire) {
      const VisitKey unasked{row_.id, target, sessions.attempts(row_.id, target) + 1};
      sessions.openVisit(unasked, utcNow());
      sessions.closeVisit(unasked, VisitStatus::Skipped, utcNow(), reason);
      ++target;
    }
    moveTo(target);
  });
}

void Session::pause(const std::string& reason) {
  require(SessionEvent::PausedSession);
  transact([&] { enter(SessionEvent::PausedSession, Actor::Operator, reason); });
}

void Session::resumeAfterPause() {
  require(SessionEvent::ResumedSession);
  transact([&] { enter(SessionEvent::ResumedSession, Actor::Operator); });
}

void Session::withdraw(const std::string& reason) {
  require(SessionEvent::Withdrew);
  transact([&] {
    leaveStep(VisitStatus::BrokenOff, reason);
    enter(SessionEvent::Withdrew, Actor::Participant, reason);
    end(SlotState::Released, reason);
  });
}

void Session::reject(const std::string& reason) {
  require(SessionEvent::WasRejected);
  transact([&] {
    leaveStep(VisitStatus::BrokenOff, reason);
    enter(SessionEvent::WasRejected, Actor::Operator, reason);
    end(SlotState::Released, reason);
  });
}

void Session::giveUpOnDevice(const std::string& reason) {
  require(SessionEvent::GaveUpOnDevice);
  transact([&] {
    enter(SessionEvent::GaveUpOnDevice, Actor::Operator, reason);
    end(SlotState::Released, reason);
  });
}

void Session::note(const std::string& text) {
  transact([&] { say(Actor::Operator, "note", text); });
}

void Session::setLanguage(const std::string& language) {
  const auto& languages = protocol_->protocol.languages;
  require(
      std::find(languages.begin(), languages.end(), language) != languages.end(),
      "The protocol has no texts in '" + language + "'.");
  transact([&] {
    row_.language = language;
    say(Actor::Participant, "chose_language", language);
  });
}

}  // namespace study
