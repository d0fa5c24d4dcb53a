// The course of a session: steps, trials, and the operator's decisions.
#include "base/search.h"
#include "study/session/session.h"
#include "study/session/trial_setup.h"
#include "study/storage/trial_repository.h"
#include "study/words/counted.h"

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
        "At least " +
            words::counted(static_cast<std::uint64_t>(present.minimumCuts), "cut is", "cuts are") +
            " needed first.");
  }
  const bool isConsent = present.kind == StepKind::Consent;
  const bool isDeclined = isConsent && !gaveConsent();
  if (isDeclined) {
    heldNames_.clear();
    removeNames(study_, row_);
  }
  transact([&] {
    if (isDeclined) {
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

void Session::skipOptionalTrial() {
  require(!isOver() && step().isOptionalTrial, "Nothing is offered in this step.");
  require(SessionEvent::SkippedStep);
  transact([&] {
    const std::string reason = "not wanted";
    leaveStep(VisitStatus::Skipped, reason);
    enter(SessionEvent::SkippedStep, Actor::Participant, reason);
    moveTo(row_.step + 1);
  });
}

void Session::beginTrial() {
  require(SessionEvent::BeganTrial);
  transact([&] { enter(SessionEvent::BeganTrial, Actor::Program); });
}

void Session::finishTrial(const TrialRecord& record) {
  require(SessionEvent::FinishedTrial);
  require(record.ending == TrialEnding::Finished, "This trial was not finished.");
  transact([&] {
    keepTrial(record);
    leaveStep(VisitStatus::Finished, "");
    enter(
        SessionEvent::FinishedTrial,
        Actor::Program,
        base::NamedArguments{
            {"cuts", static_cast<std::int64_t>(record.cuts.size())},
            {"verdict", std::string(nameOf(record.judgement().verdict))}});
    moveTo(row_.step + 1);
  });
}

void Session::abortTrial(const TrialRecord& record) {
  require(SessionEvent::BrokeOffTrial);
  transact([&] {
    keepTrial(record);
    leaveStep(VisitStatus::BrokenOff, std::string(nameOf(record.ending)));
    enter(SessionEvent::BrokeOffTrial, Actor::Program, std::string(nameOf(record.ending)));
  });
}

void Session::keepTrial(const TrialRecord& record) {
  storage::TrialRepository(study_.database()).add(visit(), record);
  appendEvent(Actor::Program, EventKind::KeptTrace, study_.traces().digest(visit()));
  const auto& passivity = record.passivity;
  base::NamedArguments values{
      {"stiffness", passivity.stiffness},
      {"period_s", passivity.effectivePeriod()},
      {"needed_damping", passivity.requiredDamping()},
      {"device_damping", record.deviceDamping},
      {"least_energy", record.leastEnergy}};
  if (passivity.limitCycle) {
    values.emplace_back("limit_cycle_n", passivity.limitCycle->amplitude);
    values.emplace_back("limit_cycle_hz", passivity.limitCycle->frequency);
  }
  appendEvent(Actor::Program, EventKind::Passivity, std::move(values));
  if (record.hasTorque) {
    appendEvent(
        Actor::Program,
        EventKind::Torque,
        base::NamedArguments{
            {"rendered", std::int64_t{record.isTorqueRendered}},
            {"largest_nm", record.largestTorque},
            {"least_energy", record.leastRotationEnergy}});
  }
  if (record.link.hasLink)
    appendEvent(Actor::Program, EventKind::DeviceLink, valuesOf(record.link));
  if (!record.deviceFault.empty())
    appendEvent(Actor::Program, EventKind::DeviceFault, record.deviceFault);
  if (record.view) appendEvent(Actor::Program, EventKind::View, valuesOf(*record.view));
  for (const auto& event : record.safety) {
    appendEvent(
        Actor::Program,
        kindOf(event.kind),
        base::NamedArguments{{"times", event.times}, {"duration_s", event.duration}});
  }
}

/// The record of a trial whose program has ended: what its stored samples tell. Of samples that
/// cannot be read, only the number is known.
TrialRecord Session::abortedRecord(TrialEnding ending) {
  TrialRecord record;
  record.traceSamples = study_.traces().sampleCount(visit());
  record.ticks = record.traceSamples;
  try {
    const auto chunks = storage::chunksOf(study_.traces().database(), visit());
    // A chunk holds the samples of a second.
    if (!chunks.empty()) {
      record = recordFrom(
          study_.traces().read(visit()),
          *deviceFor(*this).kind,
          static_cast<double>(chunks.front().samples));
    }
  } catch (const storage::StorageError&) {
    // Verifying the study says what is wrong with them.
  }
  record.ending = ending;
  return record;
}

/// In a questionnaire about a condition, the step to repeat is the trial of that condition. In the
/// step after such a questionnaire, it is the questionnaire, or the trial if the trial was not
/// finished: without its trial, no questions about a condition are asked.
int Session::stepToRepeat() const {
  if (row_.state == SessionState::Interrupted) return row_.step;
  const auto isQuestionnaire = [&](int step) {
    return plan_[static_cast<std::size_t>(step)].kind == StepKind::Questionnaire;
  };
  const int before = row_.step - 1;
  int trialStep = isQuestionnaire(row_.step) ? row_.step : before;
  while (isQuestionnaire(trialStep)) --trialStep;
  if (isQuestionnaire(row_.step) || trialStep == before) return trialStep;
  auto sessions = study_.sessions();
  const VisitKey last{row_.id, trialStep, sessions.attempts(row_.id, trialStep)};
  return sessions.statusOf(last) == VisitStatus::Finished ? before : trialStep;
}

void Session::repeatStep(const std::string& reason) {
  require(
      row_.state != SessionState::Consented || !isRightAfterConsent(),
      "Consent was given; that step is not repeated.");
  require(SessionEvent::RepeatedStep);
  const int target = stepToRepeat();
  transact([&] {
    study_.sessions().markRepeated(row_.id, target, utcNow(), reason);
    enter(SessionEvent::RepeatedStep, Actor::Operator, reason);
    moveTo(target);
  });
}

void Session::skipStep(const std::string& reason) {
  require(isOver() || step().kind != StepKind::Consent, "Consent is not skipped.");
  require(SessionEvent::SkippedStep);
  transact([&] {
    const Step skipped = step();
    auto sessions = study_.sessions();
    leaveStep(VisitStatus::Skipped, reason);
    enter(SessionEvent::SkippedStep, Actor::Operator, reason);
    int target = row_.step + 1;
    // Without the trial there is nothing to ask about, so its questionnaires are skipped, too.
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
    if (row_.state == SessionState::InTrial) keepTrial(abortedRecord(TrialEnding::Stopped));
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
    if (row_.state == SessionState::Consented) leaveStep(VisitStatus::BrokenOff, reason);
    enter(SessionEvent::GaveUpOnDevice, Actor::Operator, reason);
    end(SlotState::Released, reason);
  });
}

void Session::note(const std::string& text) {
  transact([&] { appendEvent(Actor::Operator, EventKind::Note, text); });
}

void Session::noteReamerSwitch(bool isOn) {
  transact(
      [&] { appendEvent(Actor::Participant, EventKind::SwitchedReamer, isOn ? "on" : "off"); });
}

void Session::noteForcesShown(bool areShown) {
  transact([&] { appendEvent(Actor::Operator, EventKind::ShowedForces, areShown ? "on" : "off"); });
}

void Session::setLanguage(const std::string& language) {
  const auto& languages = protocol_->protocol.languages;
  require(!isOver(), "This session is over.");
  require(base::contains(languages, language), "The protocol has no texts in '" + language + "'.");
  transact([&] {
    row_.language = language;
    appendEvent(Actor::Participant, EventKind::ChoseLanguage, language);
  });
}

}  // namespace study
