#pragma once

#include <cstdint>
#include <functional>
#include <optional>

namespace analysis {

/// The probability that a two-sided paired t-test of n participants finds a difference of d_z, the
/// mean of the differences in units of their own standard deviation:
///
///     power = P(|T| > t_c),  T noncentral t with ν = n − 1 and δ = d_z √n,
///     P(|T₀| > t_c) = α,     T₀ Student's t with ν
///
/// (Cohen 1988; both tails are counted.)
///
/// @param alpha  level of this one test: α / m in a family of m with Bonferroni's correction.
/// @throws std::invalid_argument  for fewer than two participants, an alpha that is not between 0
///     and 1, or an effect that is not finite.
double pairedTPower(double dz, std::uint64_t n, double alpha);

/// P(|T| > t_c): T is noncentral t, and t_c is the two-sided critical value of Student's t, both
/// with @p df degrees of freedom.
/// @throws std::invalid_argument  for an alpha that is not between 0 and 1, a noncentrality that is
///     not finite, or degrees of freedom that are not finite and at least 1.
double twoSidedTPower(double noncentrality, double df, double alpha);

/// The largest number of participants that is considered.
inline constexpr std::uint64_t kMostParticipants = 1'000'000;

/// The fewest participants with whom a paired t-test has at least the power @p power; std::nullopt
/// for an effect of zero and beyond kMostParticipants.
/// @throws std::invalid_argument  for an alpha or a power that is not between 0 and 1, a power
///     that is not above alpha, or an effect that is not finite.
std::optional<std::uint64_t> participantsForPower(double dz, double alpha, double power);

/// The fewest participants from @p least up to kMostParticipants for whom @p suffices returns true;
/// std::nullopt if there are none. @p suffices must be monotonic: true for n implies true for n +
/// 1.
/// @throws std::invalid_argument  for an alpha or a power that is not between 0 and 1, or a power
///     that is not above alpha.
std::optional<std::uint64_t> fewestParticipants(
    std::uint64_t least,
    double alpha,
    double power,
    const std::function<bool(std::uint64_t)>& suffices);

}  // namespace analysis
