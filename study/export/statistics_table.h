#pragma once

#include <vector>

#include "study/export/export.h"
#include "study/results/results.h"

// The tables that hold what the answers come to.
namespace study {

/// The results of every run mode that @p options ask for and that has completed sessions. They take
/// most of the time of an export: compute them once, for both tables.
std::vector<Results> resultsFor(Study& study, const ExportOptions& options);

/// Every test of a study in both profiles, one row each, in full precision: groups, method, numbers
/// of people and answers, results. Conditions have their codes, as in the answers; `declared` marks
/// the declared tests. The order of comparisons reveals the codes to a reader of the protocol, so
/// the table is not part of blinded exports.
/// @param results  by resultsFor()
ExportedTable statisticsTable(
    Study& study, const ExportOptions& options, const std::vector<Results>& results);

/// How often each alternative of a block was preferred: one row per cohort, vote and rendering,
/// with intervals of its share and the test that all are preferred equally often.
/// @param results  by resultsFor()
ExportedTable votesTable(
    Study& study, const ExportOptions& options, const std::vector<Results>& results);

}  // namespace study
