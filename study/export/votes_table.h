#pragma once

#include "study/export/export.h"

namespace study {

/// Which alternative of a block was preferred how often: one row per cohort, vote and rendering,
/// with intervals of its share and the test that all are preferred equally often.
ExportedTable votesTable(Study& study, const ExportOptions& options);

}  // namespace study
