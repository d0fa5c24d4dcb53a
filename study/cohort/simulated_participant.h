#pragma once

#include <chrono>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "base/random.h"
#include "haptics/timing/standstill_watch.h"
#include "questionnaires/model/answer.h"
#include "study/model/clock.h"
#include "study/session/session.h"

namespace study {

class DeviceSet;

/// The devices of trials in real time. Without a device set, trials run in simulated time.
struct RealtimeDevices {
  DeviceSet* deviceSet = nullptr;
  haptics::timing::StandstillWatch* watch = nullptr;  ///< restarted before each trial
};

/// A simulated participant, whose answers are drawn from a model. The realism of a condition for
/// this person is
///
///     realism(condition) + leniency(person) + taste(person, condition).
///
/// An answer to a statement is this realism, reversed if the statement's key is −1, plus noise,
/// rounded to the points of the scale. The preferred alternative is the one with the largest sum of
/// its realism and half as much noise. All random numbers depend on the seed, the place in the
/// cohort and the name of the question only, so that a session that is interrupted and resumed has
/// the same answers.
class SimulatedParticipant {
 public:
  SimulatedParticipant(
      const protocols::SimulatedAnswerModel& answerModel,
      std::uint64_t seed,
      std::string cohort,
      std::uint64_t slot);

  /// The response to @p item in the present step of @p session; std::nullopt if the participant
  /// skips the item.
  std::optional<questionnaires::Response> answer(
      const Session& session, const questionnaires::Item& item) const;

  /// A random time for the activity @p what, uniform between @p least and @p most [s].
  double secondsFor(const std::string& what, double least, double most) const;

  /// The realism of @p condition for this person; 0 is the middle of a scale.
  double realismOf(const std::string& condition) const;

 private:
  /// Random numbers that depend on the seed, the place in the cohort and @p purpose only.
  base::RandomStream stream(const std::string& purpose) const;
  /// The answer on a scale of points.
  std::int64_t drawPoint(
      const Session& session, const questionnaires::Item& item, const std::string& purpose) const;
  /// The answer on a slider about a condition: drawn from the realism like a point of a scale,
  /// rounded to the slider's step.
  double drawSliderValue(
      const Session& session, const questionnaires::Item& item, const std::string& purpose) const;
  /// The label of the preferred alternative.
  std::string drawPreferredLabel(const Session& session, const std::string& purpose) const;

  protocols::SimulatedAnswerModel answerModel_;
  std::uint64_t seed_;
  std::string cohort_;
  std::uint64_t slot_;
};

/// The end of a simulated participant's session.
struct SimulatedSessionResult {
  std::string participant;
  SessionState state = SessionState::Completed;
  int step = 0;
  int attempts = 1;    ///< at that step
  std::string reason;  ///< empty if there is none
  int trials = 0;      ///< trials of the session's plan; 0 if the session had ended before this run
  int trialsFinished = 0;
};

/// What the simulation has just committed, or that it waits for a device.
struct SimulationEvent {
  enum class Kind { Enrolment, Answer, Step, TrialOnDevice, Wait };

  Kind kind = Kind::Answer;
  std::string what;  ///< "P001 round-1 1.1"
};

/// How long a device waits for the next force before it switches its force off: the shortest such
/// time of all devices.
inline constexpr std::chrono::milliseconds kDeviceTimeout{10};

/// Called after every commit, and while the simulation waits for a device.
using SimulationCallback = std::function<void(const SimulationEvent& event)>;

/// Runs @p session from its present step to its end, with the same steps, transactions, engine and
/// recorder as a real session. Times are those of @p clock. Trials run in real time if @p
/// realtimeDevices has devices.
void simulate(
    Study& study,
    Session& session,
    SimulatedClock& clock,
    std::uint64_t seed,
    const SimulationCallback& acknowledge,
    const RealtimeDevices& realtimeDevices = {});

/// Like simulate() with simulated devices, but stops when the session has reached @p step of its
/// plan (from 0) or has ended.
void simulateUntil(
    Study& study, Session& session, SimulatedClock& clock, std::uint64_t seed, int step);

/// Simulates until @p participants simulated participants have finished, divided among the cohorts
/// in proportion to the plan. Interrupted sessions are resumed first. With a device file the trials
/// run on its devices in real time; the devices, normally emulators, move the tool themselves. A
/// trial that breaks off is repeated. Five consecutive immediate break-offs end the session. If
/// @p watch is given, break-offs while the machine stalled for longer than kDeviceTimeout do not
/// count.
/// @return how the session of each simulated participant of the study has ended.
std::vector<SimulatedSessionResult> simulateCohorts(
    Study& study,
    SimulatedClock& clock,
    int participants,
    std::uint64_t seed,
    const SimulationCallback& acknowledge,
    const std::string& deviceFile = {},
    haptics::timing::StandstillWatch* watch = nullptr);

/// The default seed of simulated hands and answers: the study's seed; at a station, a seed derived
/// from it and the station's label, so that two stations do not simulate the same people.
std::uint64_t simulationSeed(const Study& study);

/// The total number of participants that the protocol plans; a cohort without a number counts as
/// 10.
int plannedParticipants(const protocols::Protocol& protocol);

}  // namespace study
