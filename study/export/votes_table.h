#pragma once

#include "study/export/export.h"

namespace study {

/// How often each alternative of a block was preferred: one row per cohort, vote and condition,
/// with the interval of its share and the test that all are preferred equally often.
ExportedTable votesTable(Study& study, const ExportOptions& options);

}  // namespace study
