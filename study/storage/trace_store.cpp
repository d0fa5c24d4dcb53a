#include "study/storage/trace_store.h"

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstring>
#include <span>

#include "study/model/messages.h"
#include "study/storage/hasher.h"
#include "study/storage/statement.h"
#include "study/storage/transaction.h"

namespace study::storage {
namespace {

constexpr std::size_t kWithoutTorque = offsetof(TraceSample, desiredTorque);
static_assert(kWithoutTorque == 28 && sizeof(TraceSample) == 36, "as documented");
static_assert(
    std::endian::native == std::endian::little, "samples are written as they lie in memory");

/// Not even a negative zero: every bit comes back.
bool hasTorque(const TraceSample& sample) noexcept {
  return std::bit_cast<std::uint32_t>(sample.desiredTorque) != 0 ||
         std::bit_cast<std::uint32_t>(sample.torque) != 0;
}

/// The bytes of a sample in a layout; 0 for one that this program does not know.
std::size_t sizeIn(std::int64_t layout) noexcept {
  return layout == 1 ? kWithoutTorque : layout == 2 ? sizeof(TraceSample) : 0;
}

}  // namespace

/// Samples as they are written.
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

  std::int64_t samples;
  std::int64_t layout;
  std::vector<std::byte> bytes;
  Hash hash;
};

void TraceStore::add(const VisitKey& visit, int number, const std::vector<TraceSample>& samples) {
  const Chunk chunk(samples);
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
      "SELECT hash FROM chunk WHERE session_id = ? AND step = ? AND attempt = ? AND number = ?");
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
    const auto bytes = select.blob(0);
    const auto count = static_cast<std::size_t>(select.number(2));
    const std::size_t size = sizeIn(select.number(4));
    const bool isSound = size > 0 && select.number(3) == expected && bytes.size() == count * size &&
                         select.blob(1) == asBytes(hashOf(bytes));
    if (!isSound) {
      throw StorageError(
          message("traces.damaged", database_.path(), expected + 1), StorageError::Kind::Damaged);
    }
    for (std::size_t i = 0; i < count; ++i) {
      std::memcpy(&samples.emplace_back(), bytes.data() + i * size, size);
    }
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

}  // namespace study::storage
