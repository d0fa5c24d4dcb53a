#include "tests/analysis/golden_file.h"

#include <nlohmann/json.hpp>

#include "tests/support/scratch_folder.h"
#include "tests/support/shared_data.h"

namespace tests {
namespace {
std::string content(std::string_view relative) {
  return contentOf(sharedData("stats/" + std::string(relative)));
}
}  // namespace

nlohmann::json statsJson(std::string_view relative) {
  return nlohmann::json::parse(content(relative));
}

analysis::CsvTable statsTable(std::string_view relative) {
  return analysis::readCsv(content(relative));
}

analysis::GroupedValues statsGroups(const std::string& dataSet) {
  return analysis::readGroupedValues(content("two/" + dataSet + ".csv"), "g", "x");
}

}  // namespace tests
