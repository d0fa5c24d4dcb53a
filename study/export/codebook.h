#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "study/export/export.h"

namespace study {

/// What the cells of an exported column are.
enum class ColumnType { Text, Integer, Number, Boolean, DateTime };

std::string_view nameOf(ColumnType type) noexcept;

/// What the column item_type holds, in every table.
inline constexpr std::string_view kItemTypeInWords =
    "likert, semantic_differential, slider, single_choice, multiple_choice, number, short_text, "
    "long_text or pairwise_choice";

/// By its name, which means the same in every table; Text where it is not known.
ColumnType typeOf(std::string_view column) noexcept;

/// For columns with a closed list of values: the values in their natural order, for ordered
/// factors. Blinded, conditions are not among them, and their codes stand for themselves.
std::map<std::string, std::vector<Level>> levelsOf(Study& study, const ExportOptions& options);

/// The values of one column in their order: its own, or what @p byName says; none where any value
/// may stand in it.
std::vector<Level> levelsOf(
    const Column& column, const std::map<std::string, std::vector<Level>>& byName);

/// One row per item and language: what was asked, on which scale, with which key. The sentences of
/// items that name a person are there, their answers are not.
DataTable itemsTable(Study& study);

/// The same as codebookAsJson() as a table, for scripts: one row per column and value.
DataTable columnsTable(
    Study& study, const ExportOptions& options, const std::vector<DataTable>& tables);

/// What every table, column and value means, as JSON.
std::string codebookAsJson(
    Study& study, const ExportOptions& options, const std::vector<DataTable>& tables);

}  // namespace study
