#pragma once

#include <optional>
#include <vector>

#include "analysis/data/answer_table.h"
#include "analysis/summary/pairwise_comparisons.h"
#include "study/model/run_mode.h"
#include "study/results/results.h"
#include "study/session/study.h"

namespace study {

/// The profile as published alone (docs/statistics.md): how often each point was chosen, by family,
/// cohort and condition, all answers pooled, and the declared comparisons. Nothing that asks who
/// gave an answer: no flags, no votes, no tests within people. Counts every answer each time.
/// @throws storage::StorageError
Results pooledResults(Study& study, RunMode mode);

/// How often each point was chosen, by method of a table of answers.
std::vector<analysis::NamedCounts> pooledCounts(const analysis::AnswerTable& table);

/// The comparisons that a family declares, by Welch's test, of answers that were pooled; corrected
/// as declared where Welch's test is the declared one, and after Bonferroni otherwise.
analysis::PairwiseComparisons comparePooled(
    const protocols::Family& family, const std::vector<analysis::NamedCounts>& conditions);

/// What a family's correction is called where numbers are made; nothing for none.
std::optional<analysis::Adjustment> adjustmentOf(protocols::CorrectionType correction);

}  // namespace study
