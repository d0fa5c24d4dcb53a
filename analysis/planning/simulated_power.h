#pragma once

#include <cstdint>

#include "analysis/planning/likert_model.h"

namespace analysis {

/// The share of simulated studies in which a test was significant.
struct DetectionRate {
  double rate = 0.0;
  double standardError = 0.0;  ///< of the simulation: √(rate (1 − rate) / studies)
};

/// What is simulated.
struct PowerSimulation {
  LikertModel model;
  std::uint64_t participants = 12;
  double alpha = 0.05;
  std::uint64_t comparisons = 3;  ///< of the family: pairs are tested at α / comparisons
  std::uint64_t studies = 2000;
  std::uint64_t seed = 1;
};

/// How often the same simulated studies are significant by each test. "First pair": the first
/// condition against the second, where the effect is. "Any pair": at least one of all pairs of
/// conditions, which is the familywise error if there is no effect.
struct SimulatedPower {
  DetectionRate pairedT;         ///< first pair, means of participants, at α / m
  DetectionRate signedRank;      ///< the same by Wilcoxon's signed rank test, exact with ties
  DetectionRate friedman;        ///< all conditions at once, means of participants, χ², at α
  DetectionRate anyPairedT;      ///< any pair
  DetectionRate pooledWelch;     ///< first pair, all answers as if each had its own participant
  DetectionRate anyPooledWelch;  ///< any pair
};

/// The signed rank test drops differences of zero; up to 50 differences its p is exact, given the
/// ranks, beyond that normal with correction for ties and continuity. Where a test is not defined
/// (all differences equal), it has found nothing. One thread, one stream of random numbers: the
/// same arguments give the same result.
///
/// @throws std::invalid_argument  as LikertModel::check(); for fewer than two participants, no
///     studies, no comparisons, and an alpha that is not between 0 and 1.
SimulatedPower simulatePower(const PowerSimulation& simulation);

}  // namespace analysis
