#include "study/storage/disk_check.h"

#include <algorithm>
#include <array>
#include <chrono>
#include <string>
#include <system_error>
#include <vector>

#include "study/model/new_file.h"
#include "study/storage/database.h"
#include "study/storage/statement.h"
#include "study/storage/transaction.h"

namespace study::storage {
namespace {

constexpr std::array<std::string_view, 1> kSteps{"CREATE TABLE row (words TEXT NOT NULL) STRICT"};
constexpr Schema kSchema{0x70616c63, "a file for a self-test", kSteps};

/// A folder that is removed with its content by the destructor.
struct TemporaryFolder {
  std::filesystem::path path;
  ~TemporaryFolder() {
    std::error_code ignored;
    std::filesystem::remove_all(path, ignored);
  }
};

}  // namespace

CommitTimes measureCommits(const std::filesystem::path& folder, int commits) {
  using Clock = std::chrono::steady_clock;
  const TemporaryFolder passing{newFolderBeside(folder / "self-test")};
  auto database = Database::create((passing.path / "self-test.db").string(), kSchema);
  std::vector<double> times;
  for (int i = 0; i < commits; ++i) {
    const auto begin = Clock::now();
    Transaction transaction(database);
    Statement insert(database, "INSERT INTO row (words) VALUES (?)");
    insert.bind(1, std::string_view("an answer of ordinary length, with its audit line beside it"));
    insert.run();
    transaction.commit();
    times.push_back(std::chrono::duration<double>(Clock::now() - begin).count());
  }
  if (times.empty()) return {};
  std::sort(times.begin(), times.end());
  return {.commits = commits, .median = times[times.size() / 2], .longest = times.back()};
}

}  // namespace study::storage
