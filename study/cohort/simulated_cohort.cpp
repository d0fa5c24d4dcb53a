// Simulates cohorts through the same session code that real participants use.
#include <algorithm>
#include <chrono>
#include <limits>
#include <map>
#include <memory>
#include <optional>
#include <thread>

#include "base/random.h"
#include "haptics/devices/device.h"
#include "haptics/timing/standstill_watch.h"
#include "study/cohort/simulated_participant.h"
#include "study/session/trial_setup.h"
#include "study/trial/hardware_device_set.h"
#include "study/trial/live_trial.h"

namespace study {
namespace {

constexpr double kLongestTrial = 600.0;  // [s]
constexpr int kMostFailures = 30;
constexpr int kMostFailuresDuringStalls = 60;  // further ones while the machine stalled
constexpr double kImmediateFailureTime = 0.5;  // [s] from the beginning of a trial
// consecutive immediate failures after which the device counts as broken
constexpr int kMostImmediateFailures = 5;
constexpr std::chrono::milliseconds kPauseBetweenTries{500};
constexpr std::chrono::seconds kLongestWait{30};               // until a device is connected again
constexpr std::int64_t kPauseBetweenParticipants = 3'600'000;  // [ms]

using SimulationEventKind = SimulationEvent::Kind;

/// One session of a simulated participant.
class SimulatedSession {
 public:
  SimulatedSession(
      Study& study,
      Session& session,
      SimulatedClock& clock,
      std::uint64_t seed,
      const SimulationCallback& acknowledge,
      const RealtimeDevices& realtimeDevices)
      : study_(study),
        session_(session),
        clock_(clock),
        acknowledge_(acknowledge),
        devices_(realtimeDevices.deviceSet),
        watch_(realtimeDevices.watch),
        person_(
            session.protocol().protocol.simulation,
            seed,
            session.cohort(),
            static_cast<std::uint64_t>(session.slot())),
        seed_(seed) {}

  void run(int endStep = std::numeric_limits<int>::max()) {
    while (!session_.isOver() && session_.stepIndex() < endStep) {
      const std::string phase = session_.step().phase;
      if (session_.state() == SessionState::Interrupted) {
        session_.repeatStep("a trial had been broken off");
        continue;
      }
      if (session_.step().isOptionalTrial) {
        session_.skipOptionalTrial();
        continue;
      }
      if (session_.step().kind == StepKind::Trial && devices_ != nullptr) {
        runTrialOn(*devices_);  // calls acknowledge_ itself
        continue;
      }
      session_.step().kind == StepKind::Trial ? simulateTrial() : answerStep();
      acknowledge_({SimulationEventKind::Step, session_.participant() + " " + phase + " done"});
    }
  }

 private:
  void simulateTrial() {
    const int cuts = session_.step().minimumCuts;
    // Every trial gets a new hand, so that a trial repeated after a crash has the same movement.
    SimulatedDeviceSet deviceSet([&](const protocols::DeviceRequirement& need) {
      return simulatedHandFor(
          need,
          seed_,
          session_.cohort(),
          static_cast<std::uint64_t>(session_.slot()),
          feedLimitOn(session_.protocol().protocol, need.id));
    });
    Trial trial(deviceSet.device(deviceFor(session_)), setupFor(session_, study_.traces()));
    session_.beginTrial();
    const auto record = runOffline(trial, cuts, kLongestTrial);
    clock_.advance(record.duration);
    if (record.ending == TrialEnding::Finished) {
      session_.finishTrial(record);
      return;
    }
    session_.abortTrial(record);
    session_.skipStep("a simulated trial broke off");
  }

  /// Runs the trial on real devices in real time. A device that fails is connected again until one
  /// of the limits above is reached.
  void runTrialOn(DeviceSet& deviceSet) {
    const VisitKey visit = session_.visit();
    const int cuts = session_.step().minimumCuts;
    std::unique_ptr<Trial> trial;
    try {
      trial = trialFor(session_, deviceSet, study_.traces());
    } catch (const haptics::devices::DeviceError& error) {
      // An attempt with an arm that accepts no commands takes ten seconds, so the time is limited
      // as well as the number of attempts.
      const auto now = std::chrono::steady_clock::now();
      if (!waitingSince_) waitingSince_ = now;
      if (++failures_ >= kMostFailures || now - *waitingSince_ > kLongestWait) throw;
      acknowledge_({SimulationEventKind::Wait, session_.participant() + " waits: " + error.what()});
      std::this_thread::sleep_for(kPauseBetweenTries);
      return;
    }
    waitingSince_.reset();
    session_.beginTrial();
    if (watch_ != nullptr) watch_->restart();
    const auto record = runRealtime(*trial, cuts, kLongestTrial);
    const auto stoodStill = watch_ != nullptr ? watch_->longest() : std::chrono::milliseconds(0);
    trial.reset();
    clock_.advance(record.duration);
    const std::string which = session_.participant() + " step " + std::to_string(visit.step) +
                              " (" + session_.step().phase + "), attempt " +
                              std::to_string(visit.attempt) + ": ";
    if (record.ending == TrialEnding::Finished) {
      failures_ = 0;
      immediateFailures_ = 0;
      session_.finishTrial(record);
      acknowledge_({SimulationEventKind::TrialOnDevice, which + "finished"});
      return;
    }
    session_.abortTrial(record);
    const std::string why =
        record.deviceFault.empty() ? std::string(nameOf(record.ending)) : record.deviceFault;
    // A trial that broke off while the machine stalled does not show that the device is faulty.
    const bool isDisturbed = stoodStill >= kDeviceTimeout;
    if (isDisturbed) {
      ++failuresDuringStalls_;
    } else {
      immediateFailures_ = record.duration < kImmediateFailureTime ? immediateFailures_ + 1 : 0;
      ++failures_;
    }
    const bool isHopeless = failures_ >= kMostFailures ||
                            immediateFailures_ >= kMostImmediateFailures ||
                            failuresDuringStalls_ >= kMostFailuresDuringStalls;
    if (isHopeless) session_.giveUpOnDevice(why);
    const std::string machine = isDisturbed ? " (this computer stood still for " +
                                                  std::to_string(stoodStill.count()) + " ms)"
                                            : "";
    acknowledge_(
        {SimulationEventKind::TrialOnDevice,
         which + "broken off: " + why + machine + (isHopeless ? "; given up" : "; repeated")});
  }

  void answerStep() {
    const std::string phase = session_.step().phase + "/" + session_.step().condition;
    const auto items = session_.items();
    const auto givenAnswers = session_.answers();
    double shown = 0.0;
    for (std::size_t i = 0; i < items.size(); ++i) {
      if (!session_.isAsked(items[i])) continue;
      const double touched = shown + person_.secondsFor(phase + "/" + items[i].id, 1.0, 8.0);
      const auto response = person_.answer(session_, items[i]);
      const bool isAnswered = std::ranges::any_of(
          givenAnswers, [&](const auto& answer) { return answer.item == items[i].id; });
      if (!response) continue;
      if (!isAnswered) clock_.advance(touched - shown);
      shown = touched;
      if (isAnswered) continue;
      session_.record(
          {.item = items[i].id,
           .response = *response,
           .itemOrder = static_cast<int>(i) + 1,
           .firstTouch = touched,
           .responseTime = touched,
           .language = session_.language()});
      acknowledge_(
          {SimulationEventKind::Answer, session_.participant() + " " + phase + " " + items[i].id});
    }
    if (session_.step().kind == StepKind::Benchmark) {
      session_.recordBenchmarkCuts(session_.step().minimumCuts);
    }
    clock_.advance(std::max(session_.step().seconds, person_.secondsFor(phase, 2.0, 5.0)));
    session_.finishStep();
  }

  Study& study_;
  Session& session_;
  SimulatedClock& clock_;
  const SimulationCallback& acknowledge_;
  DeviceSet* devices_;
  haptics::timing::StandstillWatch* watch_;
  std::optional<std::chrono::steady_clock::time_point> waitingSince_;
  int failures_ = 0;              ///< consecutive failures of devices
  int immediateFailures_ = 0;     ///< consecutive failures before anything was rendered
  int failuresDuringStalls_ = 0;  ///< not counted in the other two
  SimulatedParticipant person_;
  std::uint64_t seed_;
};

/// The cohort with the smallest ratio of finished participants to planned ones.
std::string nextCohort(
    const protocols::Protocol& protocol, const std::map<std::string, int>& finishedByCohort) {
  std::string next;
  double least = 1e300;
  for (const auto& cohort : protocol.cohorts) {
    const auto found = finishedByCohort.find(cohort.id);
    const double count = found == finishedByCohort.end() ? 0.0 : found->second;
    const double share = count / (cohort.planned > 0 ? cohort.planned : 10);
    if (share < least) {
      least = share;
      next = cohort.id;
    }
  }
  return next;
}

/// Sets the clock to the last event of a session that is resumed.
void setClockToEndOf(SessionId session, Study& study, SimulatedClock& clock) {
  std::int64_t latest = 0;
  for (const auto& event : study.events().read(session)) {
    latest = std::max(latest, event.when.wall);
  }
  clock.setWall(latest);
}

SimulatedSessionResult sessionResultOf(const storage::SessionRow& row) {
  return {
      .participant = row.participant,
      .state = row.state,
      .step = row.step,
      .attempts = row.attempt,
      .reason = row.endReason.value_or("")};
}

SimulatedSessionResult sessionResultOf(Study& study, const Session& session) {
  auto sessions = study.sessions();
  const SessionId id = session.visit().session;
  auto ending = sessionResultOf(sessions.load(id));
  for (std::size_t i = 0; i < session.plan().size(); ++i) {
    if (session.plan()[i].kind != StepKind::Trial || session.plan()[i].isOptionalTrial) continue;
    const int step = static_cast<int>(i);
    const int attempts = sessions.attempts(id, step);
    ++ending.trials;
    if (sessions.statusOf({id, step, attempts}) == storage::VisitStatus::Finished) {
      ++ending.trialsFinished;
    }
  }
  return ending;
}

}  // namespace

void simulate(
    Study& study,
    Session& session,
    SimulatedClock& clock,
    std::uint64_t seed,
    const SimulationCallback& acknowledge,
    const RealtimeDevices& realtimeDevices) {
  SimulatedSession(study, session, clock, seed, acknowledge, realtimeDevices).run();
}

void simulateUntil(
    Study& study, Session& session, SimulatedClock& clock, std::uint64_t seed, int step) {
  const SimulationCallback ignore = [](const SimulationEvent&) {};
  SimulatedSession(study, session, clock, seed, ignore, {}).run(step);
}

std::vector<SimulatedSessionResult> simulateCohorts(
    Study& study,
    SimulatedClock& clock,
    int participants,
    std::uint64_t seed,
    const SimulationCallback& acknowledge,
    const std::string& deviceFile,
    haptics::timing::StandstillWatch* watch) {
  // Simulated participants use real devices only if a device file was named.
  std::unique_ptr<DeviceSet> devices;
  if (!deviceFile.empty()) {
    devices =
        deviceSetFor(deviceFile, study.folder(), [&](const protocols::DeviceRequirement& need) {
          return simulatedHandFor(
              need, seed, {}, 0, feedLimitOn(study.protocol().protocol, need.id));
        });
  }
  std::vector<SimulatedSessionResult> endings;
  std::map<std::string, int> finished;
  int total = 0;
  for (const auto& row : study.sessions().all()) {
    if (row.runMode != RunMode::Simulated) continue;
    if (isOver(row.state)) {
      endings.push_back(sessionResultOf(row));
    } else {
      setClockToEndOf(row.id, study, clock);
      auto session = Session::resume(study, row.id);
      simulate(study, session, clock, seed, acknowledge, {devices.get(), watch});
      endings.push_back(sessionResultOf(study, session));
    }
    ++finished[row.cohort];
    ++total;
  }
  auto lastEnrolled = study.events().latestTimeOf(EventKind::Enrolled);  // reads the whole trail
  for (; total < participants; ++total) {
    const std::string cohort = nextCohort(study.protocol().protocol, finished);
    if (lastEnrolled) clock.setWall(*lastEnrolled + kPauseBetweenParticipants);
    lastEnrolled = clock.now().wall;
    auto session =
        Session::enrol(study, {.cohort = cohort, .runMode = RunMode::Simulated, .language = "en"});
    acknowledge({SimulationEventKind::Enrolment, session.participant() + " enrolled"});
    simulate(study, session, clock, seed, acknowledge, {devices.get(), watch});
    endings.push_back(sessionResultOf(study, session));
    ++finished[cohort];
  }
  return endings;
}

std::uint64_t simulationSeed(const Study& study) {
  if (study.station().isNone()) return study.seed();
  return base::RandomStream(study.seed(), 0, "people at " + study.station().label).bits();
}

int plannedParticipants(const protocols::Protocol& protocol) {
  int planned = 0;
  for (const auto& cohort : protocol.cohorts) planned += cohort.planned > 0 ? cohort.planned : 10;
  return planned;
}

}  // namespace study
