#pragma once

#include <string>
#include <vector>

#include "study/export/column.h"
#include "study/export/export.h"

namespace study {

/// One row per item and language: what was asked, on which scale, with which key. The sentences of
/// items that name a person are there, their answers are not.
ExportedTable itemsTable(Study& study, const Readers& readers);

/// The same as codebookAsJson() as a table, for scripts: one row per column and value.
ExportedTable columnsTable(const std::vector<ExportedTable>& tables);

/// What every table, column and value means, as JSON.
std::string codebookAsJson(
    Study& study, const ExportOptions& options, const std::vector<ExportedTable>& tables);

}  // namespace study
