#pragma once

#include <string>
#include <vector>

#include "study/export/column.h"
#include "study/export/export.h"

namespace study {

/// One row per item and language: its question, scale and key. Includes the questions of items that
/// name a person, but not their answers.
ExportedTable itemsTable(Study& study, const Readers& readers);

/// The columns and values of codebookAsJson() as a table for scripts: one row per column and value.
ExportedTable columnsTable(const std::vector<ExportedTable>& tables);

/// The meaning of every table, column and value, as JSON.
std::string codebookAsJson(
    Study& study, const ExportOptions& options, const std::vector<ExportedTable>& tables);

}  // namespace study
