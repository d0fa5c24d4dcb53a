#pragma once

#include "study/export/export.h"

namespace study {

/// Every test of a study in both profiles, one row each, in full precision: groups, method, numbers
/// of people and answers, results. Conditions have their codes, as in the answers; `declared` marks
/// the declared tests. The order of comparisons reveals the codes to a reader of the protocol, so
/// the table is not part of blinded exports.
ExportedTable statisticsTable(Study& study, const ExportOptions& options);

}  // namespace study
