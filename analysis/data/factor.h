#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace analysis {

/// What answers are grouped by: the method, the round, the participant. Only levels that occur.
struct Factor {
  std::string name;
  std::vector<std::string> levels;         ///< each once; the first is the base of a comparison
  std::vector<std::size_t> levelOfAnswer;  ///< an index into levels for each answer
};

/// The factor of one label per answer, its levels in the order of their appearance.
Factor factorOf(std::string name, std::span<const std::string> labels);

/// The same with the levels in the order of @p order; those without an answer are left out.
///
/// @throws std::invalid_argument  for a label that is not in @p order.
Factor factorOf(
    std::string name, std::span<const std::string> labels, std::span<const std::string> order);

/// Each pair of levels that occurs as a level of its own: participant:method.
///
/// @throws std::invalid_argument  if the factors have different numbers of answers.
Factor crossing(const Factor& a, const Factor& b);

}  // namespace analysis
