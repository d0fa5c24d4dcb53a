#pragma once

#include "study/export/export.h"

namespace study {

/// Every test of a study in both profiles, one row each, with full precision: what was compared, by
/// which method, on how many, with which result. Conditions stand under their codes, as in
/// the answers; `declared` marks what the protocol declared. Who knows the protocol can tell from
/// the order of comparisons which code is which, so that it has no place in a blinded export.
ExportedTable statisticsTable(Study& study, const ExportOptions& options);

}  // namespace study
