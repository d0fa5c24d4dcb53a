#pragma once

#include <cmath>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numerics/interval.h"
#include "study/export/column.h"
#include "study/results/felt_curves.h"
#include "study/results/results.h"

namespace study {

/// A row of the statistics table by the names of its columns.
using StatisticsRow = std::map<std::string, Cell>;

Columns<StatisticsRow> statisticsColumns();

/// The cells that all rows of a family begin with: cohort, instrument, blocks, and level of
/// significance.
StatisticsRow headOfRow(
    const protocols::Family& family,
    const protocols::Protocol& protocol,
    std::string_view runMode,
    const std::string& cohort);

/// Adds the results of a test.
void addTest(StatisticsRow& row, const analysis::TestRow& test);

/// Rows on a cohort as a whole, without their first cells: overall tests, order, reliability and
/// distribution.
/// @param codes  of conditions
std::vector<StatisticsRow> overallRows(
    const CohortResult& cohort, const std::map<std::string, std::string>& codes);

/// Rows on questionnaires: one for each score, and one for each item with a threshold.
std::vector<StatisticsRow> instrumentRows(
    const std::vector<InstrumentSummary>& instruments,
    const std::map<std::string, std::string>& codes);

/// The forces of trials, or why they are not known: a damaged trace must not hide the answers.
struct FeltResult {
  std::vector<FeltCurve> curves;
  base::Message reason;  ///< empty, or what is wrong with the traces; then there are no curves
};

FeltResult feltResult(Study& study, RunMode mode);

/// The differences of alternatives at the handle: a row for each pair, over all cohorts; one row
/// with the reason if they are not known.
std::vector<StatisticsRow> feltRows(
    const FeltResult& felt, const std::map<std::string, std::string>& codes);

/// Infinite statistics become missing values; their row has the reason.
inline Cell finite(const std::optional<double>& value) {
  return value && std::isfinite(*value) ? Cell(*value) : Cell();
}

inline std::int64_t whole(std::uint64_t value) {
  return static_cast<std::int64_t>(value);
}

inline void addInterval(
    StatisticsRow& row,
    const std::string& name,
    const std::optional<analysis::Interval>& interval,
    const std::string& suffix = "") {
  if (!interval) return;
  row[name + "_low" + suffix] = interval->low;
  row[name + "_high" + suffix] = interval->high;
}

/// A name; an empty one becomes a missing value.
inline void addName(StatisticsRow& row, const std::string& column, const std::string& name) {
  if (!name.empty()) row[column] = name;
}

inline void addReason(StatisticsRow& row, const base::Message& reason) {
  if (!reason.empty()) row["reason"] = base::describe(reason);
}

}  // namespace study
