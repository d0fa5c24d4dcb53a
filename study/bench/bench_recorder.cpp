#include "study/bench/bench_recorder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <memory>
#include <thread>

#include "haptics/engine/realtime_loop.h"
#include "haptics/engine/sample_ring.h"
#include "study/model/user_error.h"
#include "study/storage/statement.h"
#include "study/storage/study_schema.h"
#include "study/storage/trace_store.h"
#include "study/storage/transaction.h"

namespace study::app {
namespace {

using Clock = std::chrono::steady_clock;
using storage::TraceSample;

constexpr std::size_t kChunk = 1000;

double secondsSince(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// A folder of our own in another one; gone with it.
class Corner {
 public:
  explicit Corner(const std::string& folder)
      : path_(std::filesystem::path(folder) / (".palpate-bench-" + std::to_string(getpid()))) {
    std::filesystem::create_directories(path_);
  }
  ~Corner() {
    std::error_code ignored;
    std::filesystem::remove_all(path_, ignored);
  }
  Corner(const Corner&) = delete;
  Corner& operator=(const Corner&) = delete;

  std::string operator/(const char* name) const { return (path_ / name).string(); }

 private:
  std::filesystem::path path_;
};

std::vector<TraceSample> chunkOfACut() {
  std::vector<TraceSample> chunk(kChunk);
  for (std::size_t i = 0; i < kChunk; ++i) {
    const auto t = static_cast<float>(i) * 1e-3F;
    chunk[i] = {
        .tick = static_cast<std::uint32_t>(i),
        .travel = 5.0F + 5.0F * std::sin(6.0F * t),
        .velocity = 30.0F * std::cos(6.0F * t),
        .desired = 3.0F + std::sin(9.0F * t),
        .force = 3.0F + std::sin(9.0F * t),
        .lateness = 15.0F};
  }
  return chunk;
}

/// A way of keeping a thousand samples.
class Recorder {
 public:
  virtual ~Recorder() = default;
  virtual std::string name() const = 0;
  virtual void keep(const std::vector<TraceSample>& chunk) = 0;
  virtual std::uintmax_t bytes() = 0;

  double seconds = 0.0;
  double worst = 0.0;  ///< [s]
  std::uint64_t samples = 0;
};

std::uintmax_t sizeAfterCheckpoint(storage::Database& database) {
  database.execute("PRAGMA wal_checkpoint(TRUNCATE)");
  return std::filesystem::file_size(database.path());
}

class Chunks final : public Recorder {
 public:
  explicit Chunks(const Corner& corner)
      : store_(storage::Database::create(corner / "chunks.db", storage::traceSchema())) {}
  std::string name() const override { return "palpate: chunks of a second"; }
  void keep(const std::vector<TraceSample>& chunk) override {
    store_.add({SessionId{1}, 0, 1}, number_++, chunk);
  }
  std::uintmax_t bytes() override { return sizeAfterCheckpoint(store_.database()); }

 private:
  storage::TraceStore store_;
  int number_ = 0;
};

const storage::Schema& rowSchema() {
  static constexpr std::string_view kSteps[]{
      "CREATE TABLE sample (tick INTEGER, travel REAL, velocity REAL, desired REAL, force REAL, "
      "lateness REAL, flags INTEGER) STRICT;"};
  static const storage::Schema kSchema{0x50616c42, "a benchmark of palpate", kSteps};
  return kSchema;
}

class Rows final : public Recorder {
 public:
  explicit Rows(const Corner& corner)
      : database_(storage::Database::create(corner / "rows.db", rowSchema())) {}
  std::string name() const override { return "SQLite, a row a sample, 1000 a transaction"; }
  void keep(const std::vector<TraceSample>& chunk) override {
    storage::Transaction transaction(database_);
    for (const auto& sample : chunk) {
      storage::Statement insert(database_, "INSERT INTO sample VALUES (?,?,?,?,?,?,?)");
      insert.bind(1, std::int64_t{sample.tick})
          .bind(2, static_cast<double>(sample.travel))
          .bind(3, static_cast<double>(sample.velocity))
          .bind(4, static_cast<double>(sample.desired))
          .bind(5, static_cast<double>(sample.force))
          .bind(6, static_cast<double>(sample.lateness))
          .bind(7, std::int64_t{sample.marks});
      insert.run();
    }
    transaction.commit();
  }
  std::uintmax_t bytes() override { return sizeAfterCheckpoint(database_); }

 private:
  storage::Database database_;
};

class RawFile final : public Recorder {
 public:
  explicit RawFile(const Corner& corner)
      : path_(corner / "raw"), file_(open(path_.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600)) {
    if (file_ < 0) throw UserError("No file can be written there for the benchmark.");
  }
  ~RawFile() override { close(file_); }
  RawFile(const RawFile&) = delete;
  RawFile& operator=(const RawFile&) = delete;

  std::string name() const override { return "raw file, fdatasync a chunk"; }
  void keep(const std::vector<TraceSample>& chunk) override {
    const std::size_t size = chunk.size() * sizeof(TraceSample);
    const bool isKept =
        write(file_, chunk.data(), size) == static_cast<ssize_t>(size) && fdatasync(file_) == 0;
    if (!isKept) throw UserError("The disk took no more of the benchmark.");
  }
  std::uintmax_t bytes() override { return std::filesystem::file_size(path_); }

 private:
  std::string path_;
  int file_;
};

}  // namespace

std::vector<RecorderRun> raceRecorders(const std::string& folder, double seconds) {
  const Corner corner(folder);
  std::vector<std::unique_ptr<Recorder>> recorders;
  recorders.push_back(std::make_unique<Chunks>(corner));
  recorders.push_back(std::make_unique<Rows>(corner));
  recorders.push_back(std::make_unique<RawFile>(corner));
  const auto chunk = chunkOfACut();
  const auto start = Clock::now();
  while (secondsSince(start) < seconds) {
    for (auto& recorder : recorders) {
      const auto before = Clock::now();
      recorder->keep(chunk);
      const double took = secondsSince(before);
      recorder->seconds += took;
      recorder->worst = std::max(recorder->worst, took);
      recorder->samples += chunk.size();
    }
  }
  std::vector<RecorderRun> runs;
  for (auto& recorder : recorders) {
    const auto samples = static_cast<double>(recorder->samples);
    runs.push_back(
        {.way = recorder->name(),
         .samplesPerSecond = samples / recorder->seconds,
         .bytesPerSample = static_cast<double>(recorder->bytes()) / samples,
         .worstCall = 1e3 * recorder->worst});
  }
  return runs;
}

RecorderLoop recordInLoop(const std::string& folder, double rate, double seconds) {
  using Ring = haptics::engine::SampleRing<TraceSample, 65'536>;
  const Corner corner(folder);
  storage::TraceStore store(storage::Database::create(corner / "loop.db", storage::traceSchema()));
  auto ring = std::make_unique<Ring>();
  RecorderLoop result;
  std::jthread recorder([&](const std::stop_token& stop) {
    std::vector<TraceSample> chunk;
    int number = 0;
    const auto drain = [&](bool isLast) {
      TraceSample sample;
      while (ring->pop(sample)) {
        chunk.push_back(sample);
        if (static_cast<double>(chunk.size()) < rate) continue;
        store.add({SessionId{1}, 0, 1}, number++, chunk);
        result.kept += chunk.size();
        chunk.clear();
      }
      if (isLast && !chunk.empty()) {
        store.add({SessionId{1}, 0, 1}, number, chunk);
        result.kept += chunk.size();
      }
    };
    while (!stop.stop_requested()) {
      std::this_thread::sleep_for(std::chrono::milliseconds(10));
      drain(false);
    }
    drain(true);
  });
  const auto one = chunkOfACut().front();
  {
    haptics::engine::RealtimeLoop loop({.rate = rate}, [&](double, double) {
      const auto before = Clock::now();
      ring->push(one);
      result.push.add(1e6 * secondsSince(before));
    });
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    const auto& report = loop.finish();
    result.ticks = report.ticks;
    result.seconds = report.seconds;
  }
  recorder.request_stop();
  recorder.join();
  result.lost = ring->lost();
  return result;
}

}  // namespace study::app
