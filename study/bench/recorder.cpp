#include "study/bench/recorder.h"

#include <fcntl.h>
#include <unistd.h>

#include <algorithm>
#include <chrono>
#include <cmath>
#include <filesystem>
#include <functional>
#include <memory>
#include <thread>

#include "haptics/engine/realtime_loop.h"
#include "haptics/engine/sample_ring.h"
#include "haptics/timing/stopwatch.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/storage/study_schema.h"
#include "study/storage/trace_store.h"

namespace study::bench {
namespace {

using Clock = std::chrono::steady_clock;
using storage::TraceSample;

constexpr std::size_t kChunk = 1000;

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

/// A file to which bytes are only appended: the fastest way of storing bytes safely.
class RawFile {
 public:
  explicit RawFile(const std::string& path)
      : file_(open(path.c_str(), O_CREAT | O_WRONLY | O_CLOEXEC, 0600)) {
    if (file_ < 0) throw UserError("No file can be written there for the benchmark.");
  }
  ~RawFile() { close(file_); }
  RawFile(const RawFile&) = delete;
  RawFile& operator=(const RawFile&) = delete;

  void append(const std::vector<TraceSample>& chunk) {
    const std::size_t size = chunk.size() * sizeof(TraceSample);
    const bool isKept =
        write(file_, chunk.data(), size) == static_cast<ssize_t>(size) && fdatasync(file_) == 0;
    if (!isKept) throw UserError("The disk is full: it took no more of the benchmark.");
  }

 private:
  int file_;
};

}  // namespace

std::vector<RecorderRun> compareRecorders(const std::string& folder, double seconds) {
  const TemporaryFolder scratch(folder);
  const std::string traces = (scratch / "chunks.db").string();
  const std::string raw = (scratch / "raw").string();
  storage::TraceStore store(storage::Database::create(traces, storage::traceSchema()));
  RawFile file(raw);
  struct RecorderContestant {
    RecorderRun run;
    std::function<void(const std::vector<TraceSample>&)> store;
    double seconds = 0.0;
  };
  int number = 0;
  RecorderContestant contestants[]{
      {{.method = "palpate: chunks of a second"},
       [&](const auto& chunk) {
         store.add({SessionId{1}, 0, 1}, number++, chunk);
       }},
      {{.method = "raw file, fdatasync a chunk"}, [&](const auto& chunk) { file.append(chunk); }}};
  const auto chunk = chunkOfACut();
  double chunks = 0.0;
  for (const auto start = Clock::now(); haptics::timing::secondsSince(start) < seconds; ++chunks) {
    for (auto& contestant : contestants) {
      const auto before = Clock::now();
      contestant.store(chunk);
      const double took = haptics::timing::secondsSince(before);
      contestant.seconds += took;
      contestant.run.worstCall = std::max(contestant.run.worstCall, 1e3 * took);
    }
  }
  store.database().execute("PRAGMA wal_checkpoint(TRUNCATE)");
  const double samples = chunks * static_cast<double>(chunk.size());
  std::vector<RecorderRun> runs;
  for (auto& contestant : contestants) {
    const auto bytes = std::filesystem::file_size(runs.empty() ? traces : raw);
    contestant.run.samplesPerSecond = samples / contestant.seconds;
    contestant.run.bytesPerSample = static_cast<double>(bytes) / samples;
    runs.push_back(contestant.run);
  }
  return runs;
}

RecorderLoop recordInLoop(const std::string& folder, double rate, double seconds) {
  using Ring = haptics::engine::SampleRing<TraceSample, 65'536>;
  const TemporaryFolder scratch(folder);
  storage::TraceStore store(
      storage::Database::create((scratch / "loop.db").string(), storage::traceSchema()));
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
      result.push.add(1e6 * haptics::timing::secondsSince(before));
    });
    std::this_thread::sleep_for(std::chrono::duration<double>(seconds));
    const auto& report = loop.finish();
    result.ticks = report.ticks;
    result.seconds = report.seconds;
  }
  recorder.request_stop();
  recorder.join();
  return result;
}

}  // namespace study::bench
