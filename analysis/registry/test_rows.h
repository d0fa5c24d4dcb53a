#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string_view>

#include "analysis/data/test_row.h"
#include "analysis/effects/bayes_factor.h"
#include "analysis/effects/effect_size.h"
#include "analysis/hypothesis_tests/anova.h"
#include "analysis/hypothesis_tests/assumptions.h"
#include "analysis/hypothesis_tests/contingency_tables.h"
#include "analysis/hypothesis_tests/friedman.h"
#include "analysis/hypothesis_tests/rank_tests.h"
#include "analysis/hypothesis_tests/sign_tests.h"
#include "analysis/hypothesis_tests/t_tests.h"
#include "analysis/hypothesis_tests/vote_tests.h"
#include "analysis/models/cumulative_link_mixed_model.h"
#include "analysis/models/estimates.h"
#include "analysis/models/fixed_effects.h"
#include "analysis/models/linear_mixed_model.h"
#include "analysis/reliability/intraclass_correlation.h"
#include "analysis/reliability/reliability.h"

// Conversions of results into rows. A result holds all numbers of its test; the row holds those
// that a table shows.
namespace analysis {

/// Returns @p row unchanged: for tests whose result is a row already.
inline TestRow rowOf(TestRow row) {
  return row;
}

// Two groups or more
TestRow rowOf(const WelchResult& result, const std::optional<Interval>& interval);
TestRow rowOf(const StudentResult& result);
TestRow rowOf(const MannWhitneyResult& result, const CliffDelta& delta);
TestRow rowOf(const BrunnerMunzelResult& result);
TestRow rowOf(const OneWayAnovaResult& result);
TestRow rowOf(const BrownForsytheResult& result);
TestRow rowOf(const ShapiroWilkResult& result);

// Pairs
TestRow rowOf(
    const PairedTResult& result,
    const std::optional<Interval>& interval,
    const PairedEffects& effects);
TestRow rowOf(const SignFlipResult& result);
TestRow rowOf(const SignedRankResult& result, const HodgesLehmannResult& location);
TestRow rowOf(const SignTestResult& result);
TestRow rowOf(const BayesFactor& factor, std::size_t pairs);
TestRow rowOf(const EquivalenceResult& result, const PairedTResult& test);
TestRow rowOf(const EquivalenceResult& result, const WelchResult& test);

// One line per participant
TestRow rowOf(const FriedmanResult& result);
TestRow rowOf(const RepeatedMeasuresResult& result);
TestRow rowOf(const CochranResult& result);
TestRow rowOf(const IntraclassCorrelations& all, const IntraclassCorrelation& one);
TestRow rowOf(const CronbachAlpha& alpha);
TestRow rowOf(const OmegaTotal& omega);

// Counts
TestRow rowOf(const FisherExactResult& result);
TestRow rowOf(const McNemarResult& result);
TestRow rowOf(const StuartMaxwellResult& result);
TestRow rowOf(const EqualSharesResult& result);

// Models
/// @param answers  number of answers that the model was fitted to.
TestRow rowOf(const TEstimate& estimate, std::size_t answers);
TestRow rowOf(const WaldEstimate& estimate, std::size_t answers, double level);

/// An event whose probability is estimated: an answer of at least `from` to one level of a factor.
struct HighAnswerEvent {
  std::string_view factor;
  std::string_view group;  ///< a level of the factor
  int from = 0;
};
/// The probability of high answers by a model of all @p answers, and the observed share. If the
/// model does not give a probability, the row has the reason.
/// @param fixed  fixed effects of the model.
/// @param level  of the confidence interval.
TestRow answerProbabilityRow(
    const CumulativeLinkResult& model,
    const FixedEffects& fixed,
    std::span<const int> answers,
    const HighAnswerEvent& event,
    double level);

}  // namespace analysis
