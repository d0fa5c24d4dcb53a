#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <vector>

#include "analysis/numerics/interval.h"

namespace analysis {

/// An estimate of the same effect, from one of several sites.
struct EstimateWithError {
  double estimate = 0.0;
  double standardError = 0.0;  ///< positive
};

/// One estimate made of several, each with the weight w = 1 / (its variance + τ²).
struct PooledEstimate {
  double estimate = 0.0;
  double standardError = 0.0;
  Interval interval;
  double statistic = 0.0;    ///< estimate / standard error
  std::optional<double> df;  ///< of Student's t; std::nullopt: normal
  double p = 1.0;            ///< two-sided
  double tauSquared = 0.0;   ///< variance of the effect between sites
  double iSquared = 0.0;     ///< share of the variance that is between sites, 0 … 1
};

/// Several sites, pooled (Viechtbauer 2010, J. Stat. Softw. 36(3); numbers as R's metafor has
/// them).
///
///     Q = Σ (yᵢ − μ̂)² / vᵢ of the common effect μ̂, χ² with k − 1 degrees of freedom if the sites
///         do not differ
///     τ² by DerSimonian and Laird: (Q − (k − 1)) / (Σ w − Σ w² / Σ w) with w = 1/vᵢ, not below 0
///     τ² by REML: the largest restricted likelihood, by Fisher's scoring, not below 0
///     I² = τ² / (τ² + s²), s² = (k − 1) Σ w / ((Σ w)² − Σ w²); of the common effect with the τ² of
///         DerSimonian and Laird
///
/// Knapp and Hartung's standard error is √(q / Σ w) with q = Σ w (yᵢ − μ̂)² / (k − 1), and Student's
/// t with k − 1 degrees of freedom; q counts as 1 where it is less, lest sites that happen to agree
/// give an interval narrower than each of them allows.
struct MetaAnalysis {
  std::size_t sites = 0;
  double q = 0.0;
  double qP = 1.0;
  PooledEstimate common;  ///< τ² = 0: one and the same effect everywhere
  PooledEstimate derSimonianLaird;
  PooledEstimate reml;
  PooledEstimate knappHartung;  ///< of REML
};

/// @param level  of the intervals
/// @throws std::invalid_argument  for fewer than two sites, or an error that is not positive.
MetaAnalysis pooled(std::span<const EstimateWithError> sites, double level);

/// The pooled estimate (REML, Knapp and Hartung) alone, to four digits: for simulations of
/// thousands of studies.
/// @throws std::invalid_argument  as pooled().
PooledEstimate pooledQuickly(std::span<const EstimateWithError> sites, double level);

/// The pooled estimate (REML, Knapp and Hartung) without each site in turn; empty for fewer than
/// three.
std::vector<PooledEstimate> withoutEach(std::span<const EstimateWithError> sites, double level);

}  // namespace analysis
