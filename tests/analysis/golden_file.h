#pragma once

#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

#include "analysis/data/csv_table.h"
#include "analysis/registry/test_data.h"

namespace tests {

/// A file of tests/data/stats.
nlohmann::json statsJson(std::string_view relative);
analysis::CsvTable statsTable(std::string_view relative);

/// One of the data sets two/….csv: groups a and b of column g, values in column x.
struct StatsGroups {
  analysis::NamedValues group1;
  analysis::NamedValues group2;
};
StatsGroups statsGroups(const std::string& dataSet);

}  // namespace tests
