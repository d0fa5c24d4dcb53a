#pragma once

#include <cstdint>
#include <functional>
#include <string>

#include "protocols/random_stream.h"
#include "questionnaires/answer.h"
#include "study/clock.h"
#include "study/session.h"

namespace study {

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
  protocols::RandomStream stream(const std::string& purpose) const;
  std::int64_t point(
      const Session& session, const questionnaires::Item& item, const std::string& purpose) const;
  std::string preferred(const Session& session, const std::string& purpose) const;

  protocols::SimulationTruth truth_;
  std::uint64_t seed_;
  std::string cohort_;
  std::uint64_t slot_;
};

/// Told of everything that has been committed, as soon as it has: "P001 round-1 1.1".
using Acknowledge = std::function<void(const std::string& what)>;

/// Takes @p session from where it is to its end, through the same steps, transactions, engine and
/// recorder as a real one, in @p clock's time.
void simulate(
    Study& study,
    Session& session,
    SimulatedClock& clock,
    std::uint64_t seed,
    const Acknowledge& acknowledge);

/// Brings the number of simulated participants who have finished to @p participants, spread over
/// the cohorts as they are planned; goes on with whoever was interrupted first.
void simulateCohorts(
    Study& study,
    SimulatedClock& clock,
    int participants,
    std::uint64_t seed,
    const Acknowledge& acknowledge);

/// How many participants the protocol plans in all; 10 a cohort where it does not say.
int plannedParticipants(const protocols::Protocol& protocol);

}  // namespace study
