#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace analysis {

/// How the p values of one family of tests are adjusted for their number.
///
/// With p₁ ≤ … ≤ p_m sorted by size; each p′ is limited to 1:
enum class Adjustment {
  Bonferroni,  ///< p′ = m p
  Holm,        ///< p′ᵢ = max over j ≤ i of (m − j + 1) pⱼ; Holm 1979
  Hochberg,    ///< p′ᵢ = min over j ≥ i of (m − j + 1) pⱼ; Hochberg 1988
  Hommel,  ///< closed test: Simes' test of every subset that contains the hypothesis; Hommel 1988
  BenjaminiHochberg,   ///< p′ᵢ = min over j ≥ i of m pⱼ / j; false discovery rate, 1995
  BenjaminiYekutieli,  ///< BenjaminiHochberg times 1 + 1/2 + … + 1/m: valid for any dependence,
                       ///< 2001
  HolmSidak,           ///< p′ᵢ = max over j ≤ i of 1 − (1 − pⱼ)^(m − j + 1)
};

inline constexpr std::array kAdjustments{
    Adjustment::Bonferroni,
    Adjustment::Holm,
    Adjustment::Hochberg,
    Adjustment::Hommel,
    Adjustment::BenjaminiHochberg,
    Adjustment::BenjaminiYekutieli,
    Adjustment::HolmSidak};

/// The name of a method in files: `bonferroni`, `holm`, `hochberg`, `hommel`, `bh`, `by`,
/// `holm-sidak`.
std::string_view nameOf(Adjustment method) noexcept;

/// The number of a family's tests that have a p value. A test that is not defined cannot be
/// significant by chance, and does not count.
std::size_t definedCount(std::span<const std::optional<double>> pValues);

/// The adjusted p values, in the same order; a missing p value stays missing.
///
/// @param pValues  as computed, never rounded.
/// @throws std::invalid_argument  if a p value is not between 0 and 1.
std::vector<std::optional<double>> adjust(
    std::span<const std::optional<double>> pValues, Adjustment method = Adjustment::Bonferroni);

/// The level that a single unadjusted p value is compared with: α / m.
/// @throws std::invalid_argument  if alpha is not between 0 and 1, or for no tests at all.
double alphaPerTest(double alpha, std::size_t tests);

}  // namespace analysis
