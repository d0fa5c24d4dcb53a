#pragma once

#include "study/data_table.h"
#include "study/export.h"

namespace study {

/// Which alternative of a block was preferred how often: one row per cohort, vote and rendering,
/// with intervals of its share and the test that all are preferred equally often.
DataTable votesTable(Study& study, const ExportOptions& options);

}  // namespace study
