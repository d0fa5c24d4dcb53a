#pragma once

#include <optional>

#include <nlohmann/json_fwd.hpp>

#include "analysis/data/test_row.h"
#include "analysis/summary/within_analysis.h"

namespace study::app {

using ResultJson = nlohmann::ordered_json;

/// null for missing and infinite values, which JSON does not have; the row has the reason.
ResultJson nullable(const std::optional<double>& value);
ResultJson nullable(const std::optional<bool>& value);

/// The reason why a number is missing, in English; null without one.
ResultJson reasonOf(const base::Message& reason);

/// [low, high], or null.
ResultJson limits(const std::optional<analysis::Interval>& interval);

/// Adds the numbers of a row. Undefined numbers are null; numbers that the test does not have are
/// left out.
void addRow(ResultJson& json, const analysis::TestRow& row);

/// Adds the groups that a row compares, if it compares any.
void addNames(ResultJson& json, const analysis::TestRow& row);

/// A comparison of pooled answers.
ResultJson pooledAsJson(const analysis::TestRow& test);

/// All numbers of a test that has no keys of its own.
ResultJson rowAsJson(const analysis::TestRow& test);

/// The tests within participants of a cohort: over all conditions, and of each pair.
ResultJson withinAsJson(const analysis::WithinAnalysis& within);

}  // namespace study::app
