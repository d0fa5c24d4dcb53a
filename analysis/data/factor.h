#pragma once

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace analysis {

/// A property by which answers are grouped, such as the method, the round or the participant.
/// Levels without an answer are not listed.
struct Factor {
  std::string name;
  std::vector<std::string> levels;  ///< distinct; the first is the reference level of a comparison
  std::vector<std::size_t> levelOfAnswer;  ///< for each answer, an index into levels
};

/// The factor of one label per answer, its levels in the order of their appearance.
Factor factorOf(std::string name, std::span<const std::string> labels);

/// The factor of one label per answer, its levels in the order of @p order. Levels without an
/// answer are left out.
///
/// @throws std::invalid_argument  for a label that is not in @p order.
Factor factorOf(
    std::string name, std::span<const std::string> labels, std::span<const std::string> order);

/// The interaction of two factors: one level for each pair of levels that occurs, named
/// "participant:method".
///
/// @throws std::invalid_argument  if the factors have different numbers of answers.
Factor interactionOf(const Factor& a, const Factor& b);

}  // namespace analysis
