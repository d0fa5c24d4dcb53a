#pragma once

#include <cstdint>
#include <optional>

#include "analysis/planning/simulated_power.h"

namespace analysis {

/// The number of sites of a study, and how much the difference of two conditions varies between
/// sites:
///
///     D_ij = d_z + S_j + E_ij,   Var S_j = τ²,   Var E_ij = 1,
///
/// is the difference of participant i at site j, in units of the standard deviation of the
/// participants' differences at one site. A site that is lenient as a whole needs no term, because
/// leniency cancels in differences within participants.
struct SitePlan {
  /// A cautious default. Klein et al. 2018 (Adv. Methods Pract. Psychol. Sci. 1(4), 443–490,
  /// doi:10.1177/2515245918810225) replicated 28 effects at 125 sites: τ was above 0.2 for one
  /// effect, and about 0.1 for eight.
  static constexpr double kCautiousTau = 0.2;

  std::uint64_t sites = 2;
  double deviation = kCautiousTau;  ///< τ [d_z]

  /// ρ = τ² / (1 + τ²), of the participants' differences within sites.
  double intraclassCorrelation() const;

  /// 1 + (m − 1) ρ for m = participants / sites, the factor by which the variance of the mean
  /// difference is larger than if all participants were at different sites (Kish 1965).
  double designEffect(std::uint64_t participants) const;

  /// The fewest participants with whom sites can be pooled: two at each site.
  std::uint64_t fewestParticipants() const { return 2 * sites; }

  /// @throws std::invalid_argument  for fewer than two sites, or a τ that is negative or not
  /// finite.
  void check() const;
};

/// The power of the test of the pooled difference of k sites, each with m = participants / sites
/// participants and normal differences. For sites of equal size, Knapp and Hartung's test is a
/// t-test of the sites' means with k − 1 degrees of freedom:
///
///     power = P(|T| > t_c),  T noncentral t with ν = k − 1 and δ = d_z / √((τ² + 1/m) / k).
///
/// @param alpha  level of this one test.
/// @throws std::invalid_argument  as SitePlan::check(); for fewer participants than can be pooled,
///     an alpha that is not between 0 and 1, or an effect that is not finite.
double pooledSitesPower(double dz, std::uint64_t participants, const SitePlan& plan, double alpha);

/// The fewest participants, over all sites, with whom pooledSitesPower() is at least @p power;
/// std::nullopt if no number is enough, because the variance between few sites remains.
/// @throws std::invalid_argument  as pooledSitesPower(), and for a power that is not between alpha
///     and 1.
std::optional<std::uint64_t> participantsForPower(
    double dz, const SitePlan& plan, double alpha, double power);

/// The share of simulated studies at several sites that each test finds significant; all tests use
/// the same studies. "First pair" and "any pair" as in SimulatedPower.
struct SimulatedSitePower {
  DetectionRate pooled;      ///< first pair: the sites' differences, pooled (REML, Knapp–Hartung)
  DetectionRate anyPooled;   ///< as pooled, for any pair
  DetectionRate pairedT;     ///< first pair, all participants, sites ignored
  DetectionRate anyPairedT;  ///< as pairedT, for any pair
  /// Half the width of the first pair's pooled interval at 1 − alpha, median over studies [points];
  /// std::nullopt if more than half of the studies could not be pooled.
  std::optional<double> medianHalfWidth;
};

/// Simulates studies at several sites. LikertCohort draws the participants and the shifts of each
/// site. Participants are distributed over sites as evenly as possible. Differences are pooled as
/// in compareSites(): a site whose participants all have the same difference is left out, and fewer
/// than two remaining sites count as not significant.
///
/// @throws std::invalid_argument  as simulatePower() and SitePlan::check(), and for fewer
///     participants than can be pooled.
SimulatedSitePower simulateSitePower(const PowerSimulation& simulation, const SitePlan& plan);

}  // namespace analysis
