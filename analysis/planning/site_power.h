#pragma once

#include <cstdint>
#include <optional>

#include "analysis/planning/simulated_power.h"

namespace analysis {

/// How participants are spread over sites, and how much sites differ in a difference of two
/// conditions:
///
///     D_ij = d_z + S_j + E_ij,   Var S_j = τ²,   Var E_ij = 1,
///
/// of participant i at site j, in units of the standard deviation of the participants' differences
/// at one site. Sites that are lenient as a whole need no term: it cancels within people.
struct SitePlan {
  /// Klein et al. 2018 (Adv. Methods Pract. Psychol. Sci. 1(4), 443–490,
  /// doi:10.1177/2515245918810225) had 28 effects measured again at 125 sites: one had a larger τ,
  /// eight one of about 0.1.
  static constexpr double kUsualDeviation = 0.2;

  std::uint64_t sites = 2;
  double deviation = kUsualDeviation;  ///< τ [d_z]

  /// Of the participants' differences: ρ = τ² / (1 + τ²).
  double intraclassCorrelation() const;

  /// 1 + (m − 1) ρ for m = participants / sites, the factor by which the variance of the mean
  /// difference is larger than with each participant at a site of their own (Kish 1965).
  double designEffect(std::uint64_t participants) const;

  /// The fewest participants that can be pooled: two at each site.
  std::uint64_t fewestParticipants() const { return 2 * sites; }

  /// @throws std::invalid_argument  for fewer than two sites, or a τ that is negative or not
  /// finite.
  void check() const;
};

/// The power of the pooled difference of all sites, each with m = participants / sites of normal
/// differences: Student's t with k − 1 degrees of freedom on the sites' means, as Knapp and
/// Hartung's test is for sites of one size,
///
///     power = P(|T| > t_c),  T noncentral t with ν = k − 1 and δ = d_z / √((τ² + 1/m) / k).
///
/// @param alpha  of this one test.
/// @throws std::invalid_argument  as SitePlan::check(); for fewer participants than can be pooled,
///     an alpha that is not between 0 and 1, or an effect that is NaN.
double pooledSitesPower(double dz, std::uint64_t participants, const SitePlan& plan, double alpha);

/// The fewest participants, over all sites, with whom pooledSitesPower() is at least this;
/// std::nullopt if no number is enough: more people at few sites tell nothing of other sites.
/// @throws std::invalid_argument  as pooledSitesPower(), and for a power that is not between alpha
///     and 1.
std::optional<std::uint64_t> participantsForPower(
    double dz, const SitePlan& plan, double alpha, double power);

/// How often the same simulated studies at several sites are significant. "First pair" and "any
/// pair" as in SimulatedPower.
struct SimulatedSitePower {
  DetectionRate pooled;      ///< first pair: the sites' differences, pooled (REML, Knapp–Hartung)
  DetectionRate anyPooled;   ///< any pair
  DetectionRate pairedT;     ///< first pair, all participants as if of one site
  DetectionRate anyPairedT;  ///< any pair
  /// Half the width of the first pair's pooled interval at 1 − alpha, median over studies [points];
  /// std::nullopt if nothing could be pooled in half of them.
  std::optional<double> halfWidth;
};

/// Simulates studies at several sites. Participants are drawn as LikertCohort draws them; at each
/// site each condition is shifted by a normal number, so that the difference of two has τ times the
/// standard deviation that it has between the participants of a site. Sites have participants as
/// evenly as can be. Differences are compared and pooled as compareSites() does it: a site whose
/// participants all differ alike is left out, and with fewer than two nothing is found.
///
/// @throws std::invalid_argument  as simulatePower() and SitePlan::check(), and for fewer
///     participants than can be pooled.
SimulatedSitePower simulateSitePower(const PowerSimulation& simulation, const SitePlan& plan);

}  // namespace analysis
