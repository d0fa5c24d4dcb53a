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

/// The results of Profile::AsPublished only (docs/statistics.md): how often each point was chosen,
/// by family, cohort and condition, over all answers, and the declared comparisons. Everything that
/// depends on the participant who gave an answer is left out: flags, votes, tests within
/// participants. Counts all answers on every call.
/// @throws storage::StorageError
Results pooledResults(Study& study, RunMode mode);

/// For each method of @p table, how often each point was chosen.
std::vector<analysis::NamedSample> pooledCounts(const analysis::AnswerTable& table);

/// The comparisons that a family declares, by Welch's test on pooled answers. If the family
/// declares Welch's test, p values are adjusted by the declared correction, otherwise by
/// Bonferroni's. There is no test for a single participant, whose answers are no evidence on
/// differences between people.
analysis::PairwiseComparisons comparePooled(
    const protocols::Family& family,
    const std::vector<analysis::NamedSample>& conditions,
    std::size_t participants);

/// A family's correction as a value of analysis::Adjustment; std::nullopt for none.
std::optional<analysis::Adjustment> adjustmentOf(protocols::CorrectionType correction);

}  // namespace study
