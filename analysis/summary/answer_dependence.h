#pragma once

#include <cstddef>
#include <optional>

#include "analysis/data/answer_table.h"

namespace analysis {

/// How far answers of one person go together: what pooling them as if they were independent
/// ignores.
struct AnswerDependence {
  std::size_t answers = 0;
  std::size_t participants = 0;
  /// ICC(1) of answers within participant and method (Shrout & Fleiss 1979, case 1), pooled over
  /// methods, with Searle's n₀ for unequal numbers; may be negative. std::nullopt if there is one
  /// participant, one answer each, or no scatter.
  std::optional<double> intraclassCorrelation;
  std::optional<double> designEffect;  ///< 1 + (n₀ − 1) ICC (Kish 1965)
};

AnswerDependence dependenceOf(const AnswerTable& table);

}  // namespace analysis
