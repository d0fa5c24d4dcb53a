// The program is killed while it records at 1 kHz: at most the last second is lost.
#include <signal.h>

#include <chrono>
#include <filesystem>
#include <optional>
#include <thread>

#include <gtest/gtest.h>

#include "study/storage/study_schema.h"
#include "study/storage/trace_store.h"
#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace study {
namespace kill_recorder_test {

namespace fs = std::filesystem;
using Clock = std::chrono::steady_clock;
using storage::Database;

/// The recorder's file, when it exists.
std::optional<fs::path> traceIn(const fs::path& folder) {
  for (const auto& corner : fs::directory_iterator(folder)) {
    const auto file = corner.path() / "loop.db";
    if (fs::exists(file)) return file;
  }
  return std::nullopt;
}

TEST(KilledRecorder, LosesAtMostTheLastSecond) {
  const tests::ScratchFolder folder;
  tests::ChildProcess child(
      {tests::releaseProgram(),
       "bench",
       "servo",
       "--rates",
       "1000",
       "--seconds",
       "0.1",
       "--recording",
       "60",
       "--disk",
       folder.path().string()});
  std::optional<fs::path> file;
  const auto giveUp = Clock::now() + std::chrono::seconds(20);
  while (!file && Clock::now() < giveUp) {
    std::this_thread::sleep_for(std::chrono::milliseconds(5));
    file = traceIn(folder.path());
  }
  ASSERT_TRUE(file);
  const auto start = Clock::now();
  std::this_thread::sleep_for(std::chrono::milliseconds(3500));
  child.kill(SIGKILL);
  const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
  child.finish();

  storage::TraceStore store(
      Database::open(file->string(), storage::traceSchema(), Database::Access::ReadWrite));
  const VisitKey visit{SessionId{1}, 0, 1};
  const auto samples = store.read(visit);  // throws if a chunk is not what was written
  // One second in progress, and half a second for the start and a busy machine.
  EXPECT_GE(static_cast<double>(samples.size()), 1000.0 * (elapsed - 1.5));
  EXPECT_EQ(samples.size() % 1000, 0U);
  EXPECT_EQ(static_cast<std::int64_t>(samples.size()), store.sampleCount(visit));
}

}  // namespace kill_recorder_test
}  // namespace study
