#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace analysis {

/// How the p values of one family of tests are held to account for their number.
enum class Adjustment {
  Bonferroni,  ///< p′ = min(1, m p)
};

/// How many of a family's tests there really are: those that have a p value. A test that is not
/// defined cannot find anything by chance, and does not count.
std::size_t definedCount(std::span<const std::optional<double>> pValues);

/// The adjusted p values, in the same order. What has no p value stays without one.
///
/// @param pValues  as computed, never rounded.
/// @throws std::invalid_argument  if one of them is not between 0 and 1.
std::vector<std::optional<double>> adjust(
    std::span<const std::optional<double>> pValues, Adjustment method = Adjustment::Bonferroni);

/// What a single unadjusted p value is to be compared with: α / m.
/// @throws std::invalid_argument  if alpha is not between 0 and 1, or for no tests at all.
double alphaPerTest(double alpha, std::size_t tests);

}  // namespace analysis
