// palpate-bench devices, started by `palpate bench devices`: it finds every fault on the wire.
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace devices_command_test {

using Rows = std::vector<std::vector<std::string>>;

/// The rows of a CSV file without quoted cells, without the heading.
Rows rowsOf(const std::string& file) {
  std::ifstream stream(file);
  Rows rows;
  std::string line;
  std::getline(stream, line);
  while (std::getline(stream, line)) {
    std::istringstream cells(line);
    rows.emplace_back();
    for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
  }
  return rows;
}

class DevicesCommand : public testing::Test {
 protected:
  tests::Finished bench(const std::vector<std::string>& more) {
    std::vector<std::string> call{tests::program(), "bench", "devices", "--out", out_};
    call.insert(call.end(), more.begin(), more.end());
    return tests::run(call);
  }

  tests::ScratchFolder folder_;
  std::string out_ = folder_ / "out";
};

TEST_F(DevicesCommand, FindsEveryFaultThatIsInjected) {
  const auto finished = bench({"--part", "counts", "--faults", "20"});
  EXPECT_EQ(finished.status, 0) << finished.out << finished.error;

  const auto rows = rowsOf(out_ + "/devices-counts.csv");
  ASSERT_EQ(rows.size(), 8U);  // two devices, four kinds
  for (const auto& row : rows) {
    ASSERT_GE(row.size(), 4U);
    EXPECT_EQ(row[2], "20") << row[0] << ", " << row[1];
    EXPECT_EQ(row[3], "20") << row[0] << ", " << row[1];
  }
}

TEST_F(DevicesCommand, TimesBothDevicesAtOnce) {
  const auto finished = bench({"--part", "together", "--seconds", "1"});
  EXPECT_EQ(finished.status, 0) << finished.out << finished.error;
  EXPECT_NE(finished.out.find("punch, 1000 Hz  round trip"), std::string::npos);
  EXPECT_NE(finished.out.find("arm, 200 Hz     round trip"), std::string::npos);
  EXPECT_TRUE(std::filesystem::exists(out_ + "/devices.html"));
  EXPECT_EQ(rowsOf(out_ + "/devices-times.csv").size(), 6U);
}

}  // namespace devices_command_test
