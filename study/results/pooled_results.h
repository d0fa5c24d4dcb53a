#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "analysis/data/answer_table.h"
#include "analysis/summary/pairwise_comparisons.h"
#include "study/model/run_mode.h"
#include "study/results/results.h"
#include "study/session/study.h"

namespace study {

/// The profile as published alone (docs/statistics.md): how often each point was chosen, by family,
/// cohort and condition, over all answers, and the declared comparisons. It leaves out everything
/// that needs to know who gave an answer: flags, votes, tests within people. Always counts all
/// answers anew.
/// @throws storage::StorageError
Results pooledResults(Study& study, RunMode mode);

/// How often each point was chosen, by method of a table of answers.
std::vector<analysis::NamedSample> pooledCounts(const analysis::AnswerTable& table);

/// The comparisons that a family declares, by Welch's test on pooled answers. They are adjusted as
/// declared if Welch's test is the declared one, otherwise by Bonferroni's method. Answers of one
/// person are not tested: they say nothing of how people differ.
analysis::PairwiseComparisons comparePooled(
    const protocols::Family& family,
    const std::vector<analysis::NamedSample>& conditions,
    std::size_t participants);

/// A family's correction as the analysis room names it; std::nullopt for none.
std::optional<analysis::Adjustment> adjustmentOf(protocols::CorrectionType correction);

}  // namespace study
