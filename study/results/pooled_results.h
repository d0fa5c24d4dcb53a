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

/// Results of Profile::AsPublished only (docs/statistics.md): how often each point was chosen, by
/// family, cohort and condition, over all answers, and the declared comparisons. Leaves out all
/// that depends on who gave an answer: flags, votes, tests within people. Counts all answers on
/// every call.
/// @throws storage::StorageError
Results pooledResults(Study& study, RunMode mode);

/// How often each point was chosen, for each method of a table of answers.
std::vector<analysis::NamedSample> pooledCounts(const analysis::AnswerTable& table);

/// The comparisons that a family declares, by Welch's test on pooled answers. They are adjusted as
/// declared if Welch's test is the declared one, otherwise by Bonferroni's method. Answers of a
/// single participant are not tested: they say nothing about differences between people.
analysis::PairwiseComparisons comparePooled(
    const protocols::Family& family,
    const std::vector<analysis::NamedSample>& conditions,
    std::size_t participants);

/// A family's correction as a value of analysis::Adjustment; std::nullopt for none.
std::optional<analysis::Adjustment> adjustmentOf(protocols::CorrectionType correction);

}  // namespace study
