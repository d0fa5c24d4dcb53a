#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "analysis/data/reason.h"
#include "analysis/data/vote_shares.h"

namespace analysis {

/// The exact multinomial test of equal shares: the probability, if all options were equally likely,
/// of an outcome that is not more probable than the observed one.
///
///     p = Σ n! / (v₁! … v_k!) / kⁿ   over all outcomes v whose term is not larger
///
/// Counted in whole numbers, so that ties are ties and p is exactly rounded. Nothing is returned
/// without votes, nor where the outcomes are too many to count: kⁿ > 2¹²⁶, that is from 127 votes
/// on two options, 80 on three, 64 on four.
std::optional<double> equalSharesP(const VoteCounts& votes);

/// Whether options are preferred equally often. What is missing has a reason.
struct EqualSharesResult {
  std::uint64_t votes = 0;
  std::optional<double> exactP;            ///< as equalSharesP() has it
  std::optional<double> chiSquared;        ///< Σ (v − n/k)² / (n/k)
  std::optional<double> degreesOfFreedom;  ///< k − 1
  std::optional<double> p;                 ///< of χ²; for a few votes only roughly
  std::optional<double> log10P;            ///< also where p is too small for a double
  Reason reason;                           ///< why something above is missing; empty if nothing is
};

/// If all had voted at random, how probable would an outcome as uneven be? The test takes votes as
/// independent: several of one person make p too small.
EqualSharesResult equalSharesTest(const VoteCounts& votes);

/// Whether options get as many yes, if each person says yes or no to each. What is missing has a
/// reason.
struct CochranResult {
  std::uint64_t persons = 0;
  std::uint64_t undecided = 0;  ///< who said the same to all options: they do not count
  std::optional<double> q;
  std::optional<double> degreesOfFreedom;  ///< k − 1
  std::optional<double> p;                 ///< of χ²
  std::optional<double> log10P;            ///< also where p is too small for a double
  std::optional<double> exactP;            ///< under all permutations within persons
  Reason reason;                           ///< why something above is missing; empty if nothing is
};

/// Cochran's Q (1950), with Gⱼ the yes that option j got and Lᵢ those that person i gave:
///
///     Q = (k − 1)(k ΣGⱼ² − (ΣGⱼ)²) / (k ΣLᵢ − ΣLᵢ²)
///
/// It is Friedman's test of zeros and ones, and has its exact p.
///
/// @param answers  a row per person, an answer per option.
/// @throws std::invalid_argument  for rows of unlike length or fewer than two answers.
CochranResult cochranQTest(std::span<const std::vector<bool>> answers);

}  // namespace analysis
