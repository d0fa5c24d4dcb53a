#include "tests/analysis/golden_file.h"

#include <nlohmann/json.hpp>

#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace tests {
namespace {

std::string content(const std::string& relative) {
  return contentOf(
      relative.starts_with("nist/") ? fetchedData("stats/" + relative)
                                    : testData("stats/" + relative));
}

}  // namespace

nlohmann::json statsJson(std::string_view relative) {
  return nlohmann::json::parse(content(std::string(relative)));
}

analysis::CsvTable statsTable(std::string_view relative) {
  return analysis::readCsv(content(std::string(relative)));
}

StatsGroups statsGroups(const std::string& dataSet) {
  const auto data = analysis::readTestData(
      content("two/" + dataSet + ".csv"), analysis::DataShape::TwoGroups, {});
  return {.group1 = data.values.at(0), .group2 = data.values.at(1)};
}

}  // namespace tests
