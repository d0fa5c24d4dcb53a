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

/// Devices that are felt in real time, where there are any.
struct OnDevices {
  DeviceSet* deviceSet = nullptr;
  haptics::timing::StandstillWatch* watch = nullptr;  ///< restarted before each trial
};

/// Somebody who does not exist, and answers as a model says: how real a condition feels to them is
///
///     realism(condition) + leniency(person) + taste(person, condition),
///
/// and an answer to a statement is that, seen through the statement's key, plus chance, on the
/// points of its scale. Everything is drawn from the seed, the place in the cohort and the name of
/// what is asked: who is interrupted and resumed answers as if nothing had been.
class SimulatedParticipant {
 public:
  SimulatedParticipant(
      const protocols::SimulationTruth& truth,
      std::uint64_t seed,
      std::string cohort,
      std::uint64_t slot);

  /// What they answer to @p item in @p step of @p session; nothing where they leave it out.
  std::optional<questionnaires::Response> answer(
      const Session& session, const questionnaires::Item& item) const;

  /// How long they take for something [s].
  double secondsFor(const std::string& what, double least, double most) const;

  /// How real @p condition feels to them; 0 is the middle of a scale.
  double realismOf(const std::string& condition) const;

 private:
  base::RandomStream stream(const std::string& purpose) const;
  std::int64_t point(
      const Session& session, const questionnaires::Item& item, const std::string& purpose) const;
  std::string preferred(const Session& session, const std::string& purpose) const;

  protocols::SimulationTruth truth_;
  std::uint64_t seed_;
  std::string cohort_;
  std::uint64_t slot_;
};

/// Where and how the session of somebody who does not exist came to its end.
struct SimulatedEnding {
  std::string participant;
  SessionState state = SessionState::Completed;
  int step = 0;
  int attempts = 1;    ///< of that step
  std::string reason;  ///< empty where there is none
  int trials = 0;      ///< of the plan; 0 for sessions that had been over before
  int trialsFinished = 0;
};

/// Something that has been committed, or a wait for a device.
struct Acknowledged {
  enum class Kind { Enrolment, Answer, Step, TrialOnDevice, Wait };

  Kind kind = Kind::Answer;
  std::string what;  ///< "P001 round-1 1.1"
};

/// How long a device waits for the next force before it lets go: the shortest of all.
inline constexpr std::chrono::milliseconds kDevicePatience{10};

/// Told of everything as soon as it has happened.
using Acknowledge = std::function<void(const Acknowledged& done)>;

/// Takes @p session from where it is to its end, through the same steps, transactions, engine and
/// recorder as a real one, in @p clock's time; on @p devices if there are any, in real time.
void simulate(
    Study& study,
    Session& session,
    SimulatedClock& clock,
    std::uint64_t seed,
    const Acknowledge& acknowledge,
    const OnDevices& on = {});

/// Brings the number of simulated participants who have finished to @p participants, spread over
/// the cohorts as they are planned; goes on with whoever was interrupted first. With a device file
/// the trials are felt on its devices, in real time, by whatever hand is there: an emulator's. A
/// trial that breaks off is repeated; five in a row that do so at once end the session, but for
/// those in which the machine stood still for longer than a device waits, where @p watch is there.
/// @return how the session of each simulated participant of the study has ended.
std::vector<SimulatedEnding> simulateCohorts(
    Study& study,
    SimulatedClock& clock,
    int participants,
    std::uint64_t seed,
    const Acknowledge& acknowledge,
    const std::string& deviceFile = {},
    haptics::timing::StandstillWatch* watch = nullptr);

/// How many participants the protocol plans in all; 10 a cohort where it does not say.
int plannedParticipants(const protocols::Protocol& protocol);

}  // namespace study
