#include <zlib.h>

#include <algorithm>
#include <array>
#include <cstdio>
#include <map>
#include <utility>

#include "base/joined.h"
#include "study/export/export_parts.h"
#include "study/export/study_tables.h"
#include "study/model/new_file.h"
#include "study/storage/records.h"
#include "study/storage/trace_store.h"

namespace study {
namespace {

namespace fs = std::filesystem;
using storage::StorageError;

/// Compresses to the gzip format (RFC 1952) without file name and time, so that the same text
/// always gives the same bytes.
std::string gzip(const std::string& text) {
  constexpr int kGzip = 15 + 16;  // largest window, gzip header
  constexpr int kMemory = 8;
  z_stream stream{};
  if (deflateInit2(
          &stream, Z_DEFAULT_COMPRESSION, Z_DEFLATED, kGzip, kMemory, Z_DEFAULT_STRATEGY) != Z_OK) {
    throw StorageError("There is not enough memory to compress a trace.");
  }
  std::string packed(deflateBound(&stream, text.size()), '\0');
  // zlib only reads its input, although the pointer is not const
  stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(text.data()));
  stream.avail_in = static_cast<uInt>(text.size());
  stream.next_out = reinterpret_cast<Bytef*>(packed.data());
  stream.avail_out = static_cast<uInt>(packed.size());
  const bool isDone = deflate(&stream, Z_FINISH) == Z_STREAM_END;
  packed.resize(stream.total_out);
  deflateEnd(&stream);
  if (!isDone) throw StorageError("A trace could not be compressed.");
  return packed;
}

std::string traceAsCsv(
    const Table<ExportedTick>& table,
    const std::vector<storage::TraceSample>& samples,
    double rate) {
  auto csv = base::joined(table.columns, ",", [](const auto& column) { return column.name(); });
  csv += '\n';
  for (const auto& sample : samples) {
    const ExportedTick tick{.sample = sample, .time = sample.tick / rate};
    bool isFirst = true;
    for (const auto& column : table.columns) {
      if (!std::exchange(isFirst, false)) csv += ',';
      csv += csvCell(column.cell(tick));
    }
    csv += '\n';
  }
  return csv;
}

std::string nameOf(const storage::SessionRecord& session, const VisitKey& visit) {
  std::array<char, 160> name{};
  std::snprintf(
      name.data(),
      name.size(),
      "%s_session-%d_step-%02d_attempt-%d_force.csv.gz",
      session.participant.c_str(),
      session.number,
      static_cast<int>(visit.step) + 1,
      static_cast<int>(visit.attempt));
  return name.data();
}

}  // namespace

std::size_t writeTraces(Study& study, const fs::path& folder, const ExportOptions& options) {
  const storage::Records records(study.database());
  std::map<SessionId, storage::SessionRecord> sessions;
  for (auto& session : records.sessions()) {
    if (isExported(options, session)) sessions.emplace(session.id, session);
  }
  fs::create_directories(folder);
  auto& traces = study.traces();
  const auto withTorque = traceTable();
  const auto withoutTorque = traceTableWithoutTorque();
  std::size_t written = 0;
  double seen = 0.0;
  const auto trials = records.trials();
  for (const auto& trial : trials) {
    announceProgress(
        options.progress, seen / static_cast<double>(trials.size()), "writing what was felt");
    seen += 1.0;
    const auto session = sessions.find(trial.step.visit.session);
    if (session == sessions.end() || trial.traceSamples == 0) continue;
    const auto samples = traces.read(trial.step.visit);
    // simulations without torque record zeros; their files have no columns for torque
    const bool hasTorque = std::ranges::any_of(samples, [](const auto& sample) {
      return sample.desiredTorque != 0.0F || sample.torque != 0.0F;
    });
    const auto text =
        traceAsCsv(hasTorque ? withTorque : withoutTorque, samples, trial.nominalRate);
    writeNewFile((folder / nameOf(session->second, trial.step.visit)).string(), gzip(text));
    ++written;
  }
  return written;
}

}  // namespace study
