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

/// A weighted mean of several estimates, each with the weight w = 1 / (its variance + τ²).
struct PooledEstimate {
  double estimate = 0.0;
  double standardError = 0.0;
  Interval interval;
  double statistic = 0.0;    ///< estimate / standard error
  std::optional<double> df;  ///< of Student's t; std::nullopt if the normal distribution is used
  double p = 1.0;            ///< two-sided
  double tauSquared = 0.0;   ///< variance of the effect between sites
  double iSquared = 0.0;     ///< share of the variance that is between sites, 0 … 1
};

/// Meta-analysis of several sites (Viechtbauer 2010, J. Stat. Softw. 36(3)), with the numbers of
/// R's package metafor.
///
///     Q = Σ (yᵢ − μ̂)² / vᵢ of the common effect μ̂, χ² with k − 1 degrees of freedom if the sites
///         do not differ
///     τ² by DerSimonian and Laird: (Q − (k − 1)) / (Σ w − Σ w² / Σ w) with w = 1/vᵢ, not below 0
///     τ² by REML: the largest restricted likelihood, by Fisher's scoring, not below 0
///     I² = τ² / (τ² + s²), s² = (k − 1) Σ w / ((Σ w)² − Σ w²); of the common effect with the τ² of
///         DerSimonian and Laird
///
/// Knapp and Hartung's standard error is √(q / Σ w) with q = Σ w (yᵢ − μ̂)² / (k − 1), and
/// Student's t with k − 1 degrees of freedom; q below 1 is replaced by 1, so that sites that agree
/// by chance do not give too narrow an interval.
struct MetaAnalysis {
  std::size_t sites = 0;
  double q = 0.0;
  double heterogeneityP = 1.0;
  PooledEstimate common;  ///< τ² = 0: the same effect at all sites
  PooledEstimate derSimonianLaird;
  PooledEstimate reml;
  PooledEstimate knappHartung;  ///< with τ² of REML
};

/// @param level  of the intervals
/// @throws std::invalid_argument  for fewer than two sites, or a standard error that is not
///     positive.
MetaAnalysis pooled(std::span<const EstimateWithError> sites, double level);

/// Only MetaAnalysis::knappHartung, to four digits: for simulations of thousands of studies.
/// @throws std::invalid_argument  as pooled().
PooledEstimate pooledToFourDigits(std::span<const EstimateWithError> sites, double level);

/// MetaAnalysis::knappHartung with each site left out in turn; empty for fewer than three sites.
std::vector<PooledEstimate> leaveOneOut(std::span<const EstimateWithError> sites, double level);

}  // namespace analysis
