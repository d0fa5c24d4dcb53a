#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "analysis/data/answer_table.h"
#include "analysis/data/reason.h"
#include "analysis/effects/bayes_factor.h"
#include "analysis/effects/effect_size.h"
#include "analysis/effects/rank_effects.h"
#include "analysis/models/cumulative_link_mixed_model.h"
#include "analysis/models/linear_mixed_model.h"
#include "analysis/numerics/interval.h"
#include "analysis/summary/pairwise_comparisons.h"
#include "analysis/tests/adjustment.h"
#include "analysis/tests/equivalence.h"
#include "analysis/tests/friedman.h"
#include "analysis/tests/paired_t.h"
#include "analysis/tests/repeated_measures_anova.h"
#include "analysis/tests/sign_flip.h"
#include "analysis/tests/signed_rank.h"

namespace analysis {

/// A p value, and the same held to account for the size of its family.
struct AdjustedP {
  std::optional<double> p;
  std::optional<double> adjusted;
  std::optional<bool> isSignificant;  ///< adjusted ≤ alpha
};

/// Two methods, compared within people: by every participant's mean score of each.
struct WithinComparison {
  std::string group1;
  std::string group2;
  std::vector<double> differences;  ///< one per participant, without rounding noise
  PairedTResult paired;
  std::optional<Interval> interval;          ///< of the mean difference, at 1 − alpha
  std::optional<Interval> adjustedInterval;  ///< … at 1 − alpha / m
  PairedEffects effects;
  SignFlipResult signFlip;
  SignedRankResult signedRank;  ///< zeros dropped, as Wilcoxon did
  HodgesLehmannResult location;
  BayesFactor bayes;
  std::optional<EquivalenceResult> equivalence;  ///< where a bound was declared
  TEstimate mixed;                               ///< of the linear mixed model
  std::optional<WaldEstimate> ordinal;           ///< of the cumulative link mixed model
  Reason ordinalReason;                          ///< why there is none

  AdjustedP pairedP;
  AdjustedP signFlipP;
  AdjustedP signedRankP;
  AdjustedP mixedP;
  AdjustedP ordinalP;
};

/// What a sound analysis of one cohort's answers to a family of questions says. The unit is the
/// participant; what has to be pooled is averaged first, or modelled.
struct WithinAnalysis {
  std::size_t participants = 0;  ///< who judged every method
  std::vector<std::string> leftOut;
  std::size_t tests = 0;  ///< comparisons declared
  std::optional<double> alphaPerTest;
  FriedmanResult friedman;             ///< of participants' means
  RepeatedMeasuresResult anova;        ///< of the same
  LinearMixedResult mixed;             ///< score ~ method [+ round] + (1 | participant) + (1 | …)
  CumulativeLinkResult ordinal;        ///< the same model of logits
  std::vector<WithinComparison> rows;  ///< in the order of the pairs
};

/// How the family is held to account, and what counts as no difference.
struct WithinOptions {
  double alpha = 0.05;
  std::optional<Adjustment> adjustment = Adjustment::Holm;  ///< nothing: every p for itself
  std::optional<double> equivalenceBound;                   ///< [points of the scale]
};

/// Compares methods within people (docs/statistics.md): paired t, exact sign flip, exact signed
/// rank and Bayes factor on participants' means, Friedman and repeated-measures ANOVA over all
/// methods, and two mixed models of the single answers: one of their means, one of their order.
///
/// @param pairs  of the table's methods; first − second.
/// @throws std::invalid_argument  if a pair names a method that is not there.
WithinAnalysis compareWithin(
    const AnswerTable& table, std::span<const DeclaredPair> pairs, const WithinOptions& options);

}  // namespace analysis
