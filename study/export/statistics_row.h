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

/// What every row of a family says: whose it is, what was asked where, and at which level.
StatisticsRow headOfRow(
    const protocols::Family& family,
    const protocols::Protocol& protocol,
    std::string_view runMode,
    const std::string& cohort);

/// What a test found.
void addTest(StatisticsRow& row, const analysis::TestRow& test);

/// Rows about a cohort as a whole, without their heads: overall tests, the order, reliability and
/// distribution.
/// @param codes  of conditions
std::vector<StatisticsRow> overallRows(
    const CohortResult& cohort, const std::map<std::string, std::string>& codes);

/// What questionnaires came to: a row for each score, and for each item with a threshold.
std::vector<StatisticsRow> instrumentRows(
    const std::vector<InstrumentSummary>& instruments,
    const std::map<std::string, std::string>& codes);

/// What was felt, or why that is not known: one damaged trace keeps no answers back.
struct FeltResult {
  std::vector<FeltCurve> curves;
  base::Message reason;  ///< empty, or what is wrong with the traces; then there are no curves
};

FeltResult feltResult(Study& study, RunMode mode);

/// How much alternatives differed at the handle: a row a pair, of all cohorts together; one row
/// with the reason where that is not known.
std::vector<StatisticsRow> feltRows(
    const FeltResult& felt, const std::map<std::string, std::string>& codes);

/// Infinite statistics have no place in a table; their reason says so.
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

/// A name that may be empty; then nothing.
inline void addName(StatisticsRow& row, const std::string& column, const std::string& name) {
  if (!name.empty()) row[column] = name;
}

inline void addReason(StatisticsRow& row, const base::Message& reason) {
  if (!reason.empty()) row["reason"] = base::describe(reason);
}

}  // namespace study
