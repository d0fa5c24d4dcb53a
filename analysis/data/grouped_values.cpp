#include "analysis/data/grouped_values.h"

#include <algorithm>
#include <utility>

#include "analysis/data/csv_table.h"
#include "analysis/data/decimal_number.h"
#include "analysis/data/error.h"
#include "analysis/data/nearest_name.h"

namespace analysis {
namespace {

bool isMissing(const std::string& cell) {
  return cell.empty() || cell == "NA";
}

std::string noNumber(std::size_t line, const std::string& cell, char separator) {
  const bool hasComma = cell.find(',') != std::string::npos && separator != ';';
  return "line " + std::to_string(line) + ": '" + cell + "' is no number" +
         (hasComma ? "; write the decimals after a point" : "");
}

NamedValues& groupNamed(const std::string& name, std::vector<NamedValues>& groups) {
  const auto found = std::ranges::find(groups, name, &NamedValues::name);
  if (found != groups.end()) return *found;
  return groups.emplace_back(NamedValues{.name = name, .values = {}});
}

void checkTwo(const std::vector<NamedValues>& groups, std::string_view column) {
  if (groups.size() == 2) return;
  std::vector<std::string> names;
  names.reserve(groups.size());
  for (const auto& group : groups) names.push_back(group.name);
  std::string there = "no groups";
  if (names.size() == 1) there = "one group only, " + enumerated(names);
  if (names.size() > 2) there = std::to_string(names.size()) + " groups, " + enumerated(names);
  throw Error("the column '" + std::string(column) + "' has " + there + "; two are compared");
}

}  // namespace

GroupedValues readGroupedValues(
    std::string_view csv, std::string_view groupColumn, std::string_view valueColumn) {
  const CsvTable table = readCsv(csv);
  const std::size_t groupIndex = table.columnIndex(groupColumn);
  const std::size_t valueIndex = table.columnIndex(valueColumn);
  if (table.rows.empty()) throw Error("the file has a header and no rows");
  const auto mark = table.separator == ';' ? DecimalMark::PointOrComma : DecimalMark::Point;

  std::size_t missing = 0;
  std::vector<NamedValues> groups;
  std::vector<std::string> problems;
  for (const auto& [line, cells] : table.rows) {
    const std::string& value = cells[valueIndex];
    if (isMissing(cells[groupIndex]) || isMissing(value)) ++missing;
    if (isMissing(cells[groupIndex])) continue;

    NamedValues& group = groupNamed(cells[groupIndex], groups);
    if (isMissing(value)) continue;
    const auto number = decimalNumber(value, mark);
    if (number) group.values.push_back(*number);
    if (!number) problems.push_back(noNumber(line, value, table.separator));
  }
  if (!problems.empty()) throw Error(problems);
  checkTwo(groups, groupColumn);
  return {.group1 = std::move(groups[0]), .group2 = std::move(groups[1]), .missing = missing};
}

}  // namespace analysis
