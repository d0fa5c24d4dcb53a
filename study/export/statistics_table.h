#pragma once

#include <vector>

#include "study/export/export.h"
#include "study/results/results.h"

// The tables of results: statistics and votes.
namespace study {

/// The results of each run mode that @p options select and that has completed sessions. Computing
/// them takes most of the time of an export; compute them once for both tables.
std::vector<Results> resultsFor(Study& study, const ExportOptions& options);

/// Every test of a study in both profiles, one row each, in full precision: groups, method, numbers
/// of people and answers, results. Conditions have the codes of the answers; `declared` marks
/// declared tests. Blinded exports do not have this table, because the order of comparisons would
/// reveal the codes to readers of the protocol.
/// @param results  the result of resultsFor()
ExportedTable statisticsTable(
    Study& study, const ExportOptions& options, const std::vector<Results>& results);

/// How often each condition of a block was preferred: one row per cohort, vote and condition, with
/// the interval of its share and the test of equal shares.
/// @param results  the result of resultsFor()
ExportedTable votesTable(
    Study& study, const ExportOptions& options, const std::vector<Results>& results);

}  // namespace study
