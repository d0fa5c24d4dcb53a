// A cohort that answers through the very same session code as people do.
#include <algorithm>
#include <cmath>
#include <map>

#include "study/rig.h"
#include "study/simulated_participant.h"
#include "study/trial_setup.h"

namespace study {
namespace {

constexpr double kLongestTrial = 120.0;                   // [s]
constexpr std::int64_t kBetweenParticipants = 3'600'000;  // [ms]

/// One simulated sitting.
class Sitting {
 public:
  Sitting(
      Study& study,
      Session& session,
      SimulatedClock& clock,
      std::uint64_t seed,
      const Acknowledge& acknowledge)
      : study_(study),
        session_(session),
        clock_(clock),
        acknowledge_(acknowledge),
        person_(
            session.protocol().protocol.simulation,
            seed,
            session.cohort(),
            static_cast<std::uint64_t>(session.slot())),
        seed_(seed) {}

  void run() {
    while (!session_.isOver()) {
      const std::string phase = session_.step().phase;
      if (session_.state() == SessionState::Interrupted) {
        session_.repeatStep("the program had been ended");
      } else if (session_.step().kind == StepKind::Trial) {
        feel();
      } else {
        answerStep();
      }
      acknowledge_(session_.participant() + " " + phase + " done");
    }
  }

 private:
  void feel() {
    const VisitKey visit = session_.visit();
    const int cuts = session_.step().minimumCuts;
    // The hand is fresh in every trial: one that is done again after a crash feels the same.
    SimulatedRig rig([&](const protocols::DeviceNeed& need) {
      return simulatedHandFor(
          need, seed_, session_.cohort(), static_cast<std::uint64_t>(session_.slot()));
    });
    Trial trial(
        rig.device(deviceFor(session_)), setupFor(session_, [&](int number, const auto& samples) {
          study_.traces().add(visit, number, samples);
        }));
    session_.beginTrial();
    const auto record = feelInVirtualTime(trial, cuts, kLongestTrial);
    clock_.advance(record.duration);
    if (record.ending == TrialEnding::Finished) {
      session_.finishTrial(record);
      return;
    }
    session_.breakOffTrial(record);
    session_.skipStep("a simulated trial broke off");
  }

  void answerStep() {
    const std::string phase = session_.step().phase + "/" + session_.step().condition;
    const auto items = session_.items();
    const auto already = session_.answers();
    double shown = 0.0;
    for (std::size_t i = 0; i < items.size(); ++i) {
      const double touched = shown + person_.secondsFor(phase + "/" + items[i].id, 1.0, 8.0);
      const auto response = person_.answer(session_, items[i]);
      const bool isThere = std::any_of(already.begin(), already.end(), [&](const auto& answer) {
        return answer.item == items[i].id;
      });
      if (!response) continue;
      if (!isThere) clock_.advance(touched - shown);
      shown = touched;
      if (isThere) continue;
      session_.record(
          {.item = items[i].id,
           .response = *response,
           .itemOrder = static_cast<int>(i) + 1,
           .firstTouch = touched,
           .responseTime = touched,
           .language = session_.language()});
      acknowledge_(session_.participant() + " " + phase + " " + items[i].id);
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
  const Acknowledge& acknowledge_;
  SimulatedParticipant person_;
  std::uint64_t seed_;
};

/// The cohort that is furthest behind its plan.
std::string nextCohort(
    const protocols::Protocol& protocol, const std::map<std::string, int>& have) {
  std::string next;
  double least = 1e300;
  for (const auto& cohort : protocol.cohorts) {
    const auto found = have.find(cohort.id);
    const double count = found == have.end() ? 0.0 : found->second;
    const double share = count / (cohort.planned > 0 ? cohort.planned : 10);
    if (share < least) {
      least = share;
      next = cohort.id;
    }
  }
  return next;
}

/// A new sitting begins an hour after the last one did; a resumed one goes on where it was.
void setClockFor(Study& study, SimulatedClock& clock, std::optional<SessionId> resumed) {
  std::int64_t latest = 0;
  std::int64_t latestStart = 0;
  for (const auto& event : study.events().read(resumed)) {
    latest = std::max(latest, event.when.wall);
    if (event.kind == "enrolled") latestStart = std::max(latestStart, event.when.wall);
  }
  if (resumed) {
    clock.setWall(latest);
  } else if (latestStart > 0) {
    clock.setWall(latestStart + kBetweenParticipants);
  }
}

}  // namespace

void simulate(
    Study& study,
    Session& session,
    SimulatedClock& clock,
    std::uint64_t seed,
    const Acknowledge& acknowledge) {
  Sitting(study, session, clock, seed, acknowledge).run();
}

void simulateCohorts(
    Study& study,
    SimulatedClock& clock,
    int participants,
    std::uint64_t seed,
    const Acknowledge& acknowledge) {
  std::map<std::string, int> finished;
  int total = 0;
  for (const auto& row : study.sessions().all()) {
    if (row.runMode != RunMode::Simulated) continue;
    if (!isOver(row.state)) {
      setClockFor(study, clock, row.id);
      auto session = Session::resume(study, row.id);
      simulate(study, session, clock, seed, acknowledge);
    }
    ++finished[row.cohort];
    ++total;
  }
  for (; total < participants; ++total) {
    const std::string cohort = nextCohort(study.protocol().protocol, finished);
    setClockFor(study, clock, std::nullopt);
    auto session =
        Session::enrol(study, {.cohort = cohort, .runMode = RunMode::Simulated, .language = "en"});
    acknowledge(session.participant() + " enrolled");
    simulate(study, session, clock, seed, acknowledge);
    ++finished[cohort];
  }
}

int plannedParticipants(const protocols::Protocol& protocol) {
  int planned = 0;
  for (const auto& cohort : protocol.cohorts) planned += cohort.planned > 0 ? cohort.planned : 10;
  return planned;
}

}  // namespace study
