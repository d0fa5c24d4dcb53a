#include "study/storage/trace_store.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <optional>
#include <span>
#include <string_view>

#include "study/model/messages.h"
#include "study/storage/hasher.h"
#include "study/storage/required_key.h"
#include "study/storage/statement.h"

namespace study::storage {
namespace {

constexpr std::size_t kWithoutTorque = offsetof(TraceSample, desiredTorque);
static_assert(kWithoutTorque == 28 && sizeof(TraceSample) == 36, "as documented");
static_assert(
    std::endian::native == std::endian::little, "samples are written as they lie in memory");

/// Whether a sample has a torque. Compares bits, so that even a negative zero counts and is
/// restored exactly.
bool hasTorque(const TraceSample& sample) noexcept {
  return std::bit_cast<std::uint32_t>(sample.desiredTorque) != 0 ||
         std::bit_cast<std::uint32_t>(sample.torque) != 0;
}

constexpr std::int64_t kSealed = 2;  ///< added to the layout of sealed chunks

bool isSealed(std::int64_t layout) noexcept {
  return layout > kSealed;
}

/// The size of a sample in a layout [bytes]; 0 for an unknown layout.
std::size_t sizeIn(std::int64_t layout) noexcept {
  const auto open = isSealed(layout) ? layout - kSealed : layout;
  return open == 1 ? kWithoutTorque : open == 2 ? sizeof(TraceSample) : 0;
}

std::string placeOf(const VisitKey& visit, std::int64_t number) {
  return "trace/" + std::to_string(static_cast<std::int64_t>(visit.session)) + "/" +
         std::to_string(visit.step) + "/" + std::to_string(visit.attempt) + "/" +
         std::to_string(number);
}

std::string_view textOf(const std::vector<std::byte>& bytes) {
  return {reinterpret_cast<const char*>(bytes.data()), bytes.size()};
}

/// The plain text; std::nullopt if it was changed. @throws StorageError  without the key
std::optional<std::string> opened(
    const Database& database,
    const std::vector<std::byte>& sealed,
    const VisitKey& visit,
    std::int64_t number) {
  return requireKey(database).open(sealed, placeOf(visit, number));
}

/// The size of the samples of a chunk, unsealed [bytes].
std::size_t sizeOf(const TraceChunk& chunk) noexcept {
  return static_cast<std::size_t>(chunk.samples) * sizeIn(chunk.layout);
}

TraceChunk chunkOf(const VisitKey& visit, int number, const std::vector<TraceSample>& samples) {
  const std::int64_t layout = std::ranges::any_of(samples, hasTorque) ? 2 : 1;
  const std::size_t size = sizeIn(layout);
  TraceChunk chunk{
      .step = visit.step,
      .attempt = visit.attempt,
      .number = number,
      .samples = static_cast<std::int64_t>(samples.size()),
      .layout = layout,
      .data = std::vector<std::byte>(samples.size() * size),
      .hash = {}};
  for (std::size_t i = 0; i < samples.size(); ++i) {
    std::memcpy(chunk.data.data() + i * size, &samples[i], size);
  }
  chunk.hash = asBytes(hashOf(chunk.data));
  return chunk;
}

}  // namespace

void TraceStore::add(
    const VisitKey& visit, int number, const std::vector<TraceSample>& samples, Sealing sealing) {
  auto chunk = chunkOf(visit, number, samples);
  if (sealing == Sealing::IfThereIsAKey && database_.key() != nullptr) {
    chunk = sealed(chunk, visit.session, *database_.key());
  }
  try {
    Transaction transaction(database_);
    addChunk(database_, visit.session, chunk);
    transaction.commit();
  } catch (const StorageError&) {
    // The commit may have succeeded although it reported an error: read the chunk back.
    if (!holds(visit, chunk)) throw;
  }
}

bool TraceStore::holds(const VisitKey& visit, const TraceChunk& chunk) const {
  Statement select(
      database_,
      "SELECT hash FROM chunk "
      "WHERE session_id = ? AND step = ? AND attempt = ? AND number = ?");
  select.bindAll(visit, chunk.number);
  return select.step() && select.blob(0) == chunk.hash;
}

std::vector<TraceChunk> TraceStore::intactChunks(const VisitKey& visit) const {
  auto chunks = chunksOf(database_, visit);
  std::int64_t expected = 0;
  for (const auto& chunk : chunks) {
    const bool isSound = sizeIn(chunk.layout) > 0 && chunk.number == expected &&
                         chunk.hash == asBytes(hashOf(chunk.data)) &&
                         (isSealed(chunk.layout) || chunk.data.size() == sizeOf(chunk));
    if (!isSound) failAt(expected);
    ++expected;
  }
  return chunks;
}

std::vector<TraceSample> TraceStore::read(const VisitKey& visit) const {
  std::vector<TraceSample> samples;
  for (const auto& chunk : intactChunks(visit)) {
    const auto bytes = isSealed(chunk.layout) ? opened(database_, chunk.data, visit, chunk.number)
                                              : std::string(textOf(chunk.data));
    if (!bytes || bytes->size() != sizeOf(chunk)) failAt(chunk.number);
    const std::size_t size = sizeIn(chunk.layout);
    for (std::size_t at = 0; at < bytes->size(); at += size) {
      std::memcpy(&samples.emplace_back(), bytes->data() + at, size);
    }
  }
  return samples;
}

void TraceStore::failAt(std::int64_t chunk) const {
  throw StorageError(
      message("traces.damaged", database_.path(), chunk + 1), StorageError::Kind::Damaged);
}

std::int64_t TraceStore::intactSampleCount(const VisitKey& visit) const {
  if (database_.key() != nullptr) return static_cast<std::int64_t>(read(visit).size());
  std::int64_t samples = 0;
  for (const auto& chunk : intactChunks(visit)) samples += chunk.samples;
  return samples;
}

std::int64_t TraceStore::sampleCount(const VisitKey& visit) const {
  Statement select(
      database_,
      "SELECT coalesce(sum(samples), 0) FROM chunk WHERE session_id = ? AND step = ? AND attempt = "
      "?");
  select.bindAll(visit);
  select.step();
  return select.number(0);
}

std::string TraceStore::digest(const VisitKey& visit) const {
  Statement select(
      database_,
      "SELECT number, samples, layout, hash FROM chunk "
      "WHERE session_id = ? AND step = ? AND attempt = ? ORDER BY number");
  select.bindAll(visit);
  Hasher hasher;
  while (select.step()) {
    for (int column = 0; column < select.columnCount(); ++column) {
      hasher.add(select.exactBytes(column));
    }
  }
  return inHexadecimal(hasher.finish());
}

std::vector<VisitKey> TraceStore::visits() const {
  Statement select(
      database_, "SELECT DISTINCT session_id, step, attempt FROM chunk ORDER BY 1, 2, 3");
  std::vector<VisitKey> visits;
  while (select.step()) {
    visits.push_back(
        {SessionId{select.number(0)},
         static_cast<int>(select.number(1)),
         static_cast<int>(select.number(2))});
  }
  return visits;
}

std::vector<TraceChunk> chunksOf(const Database& traces, const VisitKey& visit) {
  Statement select(
      traces,
      "SELECT number, samples, layout, data, hash FROM chunk "
      "WHERE session_id = ? AND step = ? AND attempt = ? ORDER BY number");
  select.bindAll(visit);
  std::vector<TraceChunk> chunks;
  while (select.step()) {
    chunks.push_back(
        {.step = visit.step,
         .attempt = visit.attempt,
         .number = select.number(0),
         .samples = select.number(1),
         .layout = select.number(2),
         .data = select.blob(3),
         .hash = select.blob(4)});
  }
  return chunks;
}

void addChunk(Database& traces, SessionId session, const TraceChunk& chunk) {
  if (asBytes(hashOf(chunk.data)) != chunk.hash) {
    throw StorageError(
        "A trace that was collected is not what was recorded. 'palpate collect check' says of "
        "which session.",
        StorageError::Kind::Damaged);
  }
  Statement insert(
      traces,
      "INSERT INTO chunk (session_id, step, attempt, number, samples, layout, data, hash) "
      "VALUES (?,?,?,?,?,?,?,?)");
  insert.bindAll(
      VisitKey{session, chunk.step, chunk.attempt},
      chunk.number,
      chunk.samples,
      chunk.layout,
      chunk.data,
      chunk.hash);
  insert.run();
}

TraceChunk opened(const TraceChunk& chunk, SessionId session, const SealingKey& key) {
  if (!isSealed(chunk.layout)) return chunk;
  const auto text =
      key.open(chunk.data, placeOf({session, chunk.step, chunk.attempt}, chunk.number));
  if (!text) {
    throw StorageError(
        "samples cannot be opened with the station's key", StorageError::Kind::Damaged);
  }
  auto open = chunk;
  const auto bytes = std::as_bytes(std::span(*text));
  open.data.assign(bytes.begin(), bytes.end());
  open.layout -= kSealed;
  open.hash = asBytes(hashOf(open.data));
  return open;
}

TraceChunk sealed(const TraceChunk& chunk, SessionId session, const SealingKey& key) {
  auto sealed = chunk;
  sealed.data = key.sealDeterministically(
      textOf(chunk.data), placeOf({session, chunk.step, chunk.attempt}, chunk.number));
  sealed.layout += kSealed;
  sealed.hash = asBytes(hashOf(sealed.data));
  return sealed;
}

}  // namespace study::storage
