#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/answer_table.h"
#include "analysis/data/test_row.h"
#include "analysis/hypothesis_tests/adjustment.h"
#include "analysis/models/cumulative_link_mixed_model.h"
#include "analysis/models/linear_mixed_model.h"
#include "analysis/summary/pairwise_comparisons.h"

namespace analysis {

/// The reasons why a study has no ordinal model although the model could be fitted.
inline constexpr auto kWithinMessages = std::to_array<base::MessageKind>(
    {{"no_points_to_order", "numbers between points are not modelled as ordered"},
     {"too_many_points_for_order", "a scale of more than {} points is not modelled as ordered"}});

/// The largest number of points of a scale with an ordinal model: each point adds a parameter.
inline constexpr int kMostPointsOfOrdinalModel = 20;

/// Two methods, compared within participants.
struct WithinComparison {
  std::string group1;
  std::string group2;
  /// The registered tests of pairs (StudyUse) on every participant's mean score of each method,
  /// equivalence tests only if a bound was declared; then `mixed_model` and `ordinal_model`.
  std::vector<TestRow> tests;

  const TestRow& test(std::string_view id) const { return testNamed(tests, id); }
};

/// The analysis of one cohort's answers to a family of questions. The statistical unit is the
/// participant: repeated answers are averaged first, or described by a mixed model.
struct WithinAnalysis {
  std::size_t participants = 0;                   ///< number who judged every method
  std::vector<std::string> excludedParticipants;  ///< participants who did not judge every method
  std::size_t tests = 0;                          ///< number of declared comparisons
  std::optional<double> alphaPerTest;
  std::vector<TestRow> overall;  ///< the registered tests of all methods at once
  LinearMixedResult mixed;       ///< score ~ method [+ round] + (1 | participant) + (1 | …)
  CumulativeLinkResult ordinal;  ///< cumulative link model with the same terms
  /// `answer_probability` of each method: the probability of answers above the middle of the scale,
  /// from `ordinal`.
  std::vector<TestRow> probabilities;
  std::vector<WithinComparison> rows;  ///< in the order of the pairs
};

/// The level and adjustment of the family, and the equivalence margin.
struct WithinOptions {
  double alpha = 0.05;
  /// std::nullopt: p values are not adjusted.
  std::optional<Adjustment> adjustment = Adjustment::Holm;
  std::optional<double> equivalenceBound;  ///< [points of the scale]
};

/// Name of the factor of the models whose levels are the compared methods.
inline constexpr const char* kMethodFactorName = "method";

/// The model of the single answers:
///
///     score ~ method [+ round] + (1 | participant) + (1 | participant:method)
///
/// Round is included only if there are several rounds, the second intercept only if a participant
/// has several answers about a method.
struct MixedDesign {
  FixedEffects fixed;
  std::vector<Factor> random;
  std::vector<double> scores;
};
MixedDesign mixedDesignOf(const AnswerTable& table);

/// Whether both methods of the pair have answers in the design.
bool hasLevels(const FixedEffects& fixed, const DeclaredPair& pair);

/// The index of a method. @throws std::invalid_argument if there is no such method.
std::size_t indexOfMethod(const AnswerTable& table, const std::string& method);

/// Compares methods within participants (docs/statistics.md): the registered tests of pairs and of
/// all methods on participants' means, and two mixed models of the single answers, a linear and an
/// ordinal one.
///
/// @param pairs  pairs of the table's methods; the sign is first − second.
/// @throws std::invalid_argument  if a pair names a method that is not there.
WithinAnalysis compareWithin(
    const AnswerTable& table, std::span<const DeclaredPair> pairs, const WithinOptions& options);

}  // namespace analysis
