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
#include "study/storage/keys/sealed_condition.h"
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
  if (database.key() == nullptr) throw StorageError(adviceOnMissingKey("FOLDER", false));
  return database.key()->open(sealed, placeOf(visit, number));
}

}  // namespace

/// A chunk of samples in its stored form.
struct TraceStore::Chunk {
  explicit Chunk(const std::vector<TraceSample>& written)
      : samples(static_cast<std::int64_t>(written.size())),
        layout(std::any_of(written.begin(), written.end(), hasTorque) ? 2 : 1),
        bytes(written.size() * sizeIn(layout)) {
    const std::size_t size = sizeIn(layout);
    for (std::size_t i = 0; i < written.size(); ++i) {
      std::memcpy(bytes.data() + i * size, &written[i], size);
    }
    hash = hashOf(bytes);
  }

  /// Seals the bytes and hashes the sealed bytes. A hash of the samples could be compared with that
  /// of a simulation, and reveal the condition.
  void seal(const SealingKey& key, const std::string& place) {
    bytes = key.sealDeterministically(textOf(bytes), place);
    layout += kSealed;
    hash = hashOf(bytes);
  }

  std::int64_t samples;
  std::int64_t layout;
  std::vector<std::byte> bytes;
  Hash hash{};
};

void TraceStore::add(
    const VisitKey& visit, int number, const std::vector<TraceSample>& samples, Sealing sealing) {
  Chunk chunk(samples);
  if (sealing == Sealing::IfThereIsAKey && database_.key() != nullptr) {
    chunk.seal(*database_.key(), placeOf(visit, number));
  }
  try {
    insert(visit, number, chunk);
  } catch (const StorageError&) {
    // The commit may have succeeded although it reported an error: read the chunk back.
    if (!holds(visit, number, chunk)) throw;
  }
}

void TraceStore::insert(const VisitKey& visit, int number, const Chunk& chunk) {
  Transaction transaction(database_);
  Statement insert(
      database_,
      "INSERT INTO chunk (session_id, step, attempt, number, samples, layout, data, hash) "
      "VALUES (?,?,?,?,?,?,?,?)");
  insert.bind(1, visit);
  insert.bind(4, std::int64_t{number})
      .bind(5, chunk.samples)
      .bind(6, chunk.layout)
      .bind(7, std::span<const std::byte>(chunk.bytes))
      .bind(8, std::span<const std::byte>(chunk.hash));
  insert.run();
  transaction.commit();
}

bool TraceStore::holds(const VisitKey& visit, int number, const Chunk& chunk) const {
  Statement select(
      database_,
      "SELECT hash FROM chunk "
      "WHERE session_id = ? AND step = ? AND attempt = ? AND number = ?");
  select.bind(1, visit);
  select.bind(4, std::int64_t{number});
  return select.step() && select.blob(0) == asBytes(chunk.hash);
}

std::vector<TraceSample> TraceStore::read(const VisitKey& visit) const {
  Statement select(
      database_,
      "SELECT data, hash, samples, number, layout FROM chunk "
      "WHERE session_id = ? AND step = ? AND attempt = ? ORDER BY number");
  select.bind(1, visit);
  std::vector<TraceSample> samples;
  for (std::int64_t expected = 0; select.step(); ++expected) {
    const auto stored = select.blob(0);
    const auto count = static_cast<std::size_t>(select.number(2));
    const std::size_t size = sizeIn(select.number(4));
    const bool isAsStored = select.blob(1) == asBytes(hashOf(stored));
    const auto bytes = !isSealed(select.number(4)) ? std::optional(std::string(textOf(stored)))
                       : isAsStored                ? opened(database_, stored, visit, expected)
                                                   : std::nullopt;
    const bool isSound = size > 0 && select.number(3) == expected && isAsStored && bytes &&
                         bytes->size() == count * size;
    if (!isSound) failAt(expected);
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(&samples.emplace_back(), bytes->data() + i * size, size);
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
  Statement select(
      database_,
      "SELECT data, hash, samples, number, layout FROM chunk "
      "WHERE session_id = ? AND step = ? AND attempt = ? ORDER BY number");
  select.bind(1, visit);
  std::int64_t samples = 0;
  for (std::int64_t expected = 0; select.step(); ++expected) {
    const auto size = static_cast<std::int64_t>(sizeIn(select.number(4)));
    const auto stored = select.blob(0);
    const auto count = select.number(2);
    const bool isSound =
        size > 0 && select.number(3) == expected && select.blob(1) == asBytes(hashOf(stored)) &&
        (isSealed(select.number(4)) || static_cast<std::int64_t>(stored.size()) == count * size);
    if (!isSound) failAt(expected);
    samples += count;
  }
  return samples;
}

std::int64_t TraceStore::sampleCount(const VisitKey& visit) const {
  Statement select(
      database_,
      "SELECT coalesce(sum(samples), 0) FROM chunk WHERE session_id = ? AND step = ? AND attempt = "
      "?");
  select.bind(1, visit);
  select.step();
  return select.number(0);
}

std::string TraceStore::digest(const VisitKey& visit) const {
  Statement select(
      database_,
      "SELECT number, samples, layout, hash FROM chunk "
      "WHERE session_id = ? AND step = ? AND attempt = ? ORDER BY number");
  select.bind(1, visit);
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
  select.bind(1, visit);
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
  insert.bind(1, VisitKey{session, chunk.step, chunk.attempt});
  insert.bind(4, chunk.number)
      .bind(5, chunk.samples)
      .bind(6, chunk.layout)
      .bind(7, std::span<const std::byte>(chunk.data))
      .bind(8, std::span<const std::byte>(chunk.hash));
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
