#include "study/storage/trace_store.h"

#include <bit>
#include <cstring>

#include "study/model/messages.h"
#include "study/storage/hasher.h"
#include "study/storage/statement.h"
#include "study/storage/transaction.h"

namespace study::storage {
namespace {

constexpr std::int64_t kLayout = 1;
static_assert(sizeof(TraceSample) == 28, "as documented");
static_assert(
    std::endian::native == std::endian::little, "samples are written as they lie in memory");

}  // namespace

void TraceStore::add(const VisitKey& visit, int number, const std::vector<TraceSample>& samples) {
  try {
    insert(visit, number, samples);
  } catch (const StorageError&) {
    // The commit may have succeeded although it reported an error: read the chunk back.
    if (!holds(visit, number, samples)) throw;
  }
}

void TraceStore::insert(
    const VisitKey& visit, int number, const std::vector<TraceSample>& samples) {
  const auto bytes = std::as_bytes(std::span(samples));
  const Hash hash = hashOf(bytes);
  Transaction transaction(database_);
  Statement insert(
      database_,
      "INSERT INTO chunk (session_id, step, attempt, number, samples, layout, data, hash) "
      "VALUES (?,?,?,?,?,?,?,?)");
  insert.bind(1, visit);
  insert.bind(4, std::int64_t{number})
      .bind(5, static_cast<std::int64_t>(samples.size()))
      .bind(6, kLayout)
      .bind(7, bytes)
      .bind(8, std::span<const std::byte>(hash));
  insert.run();
  transaction.commit();
}

bool TraceStore::holds(
    const VisitKey& visit, int number, const std::vector<TraceSample>& samples) const {
  Statement select(
      database_,
      "SELECT hash FROM chunk WHERE session_id = ? AND step = ? AND attempt = ? AND number = ?");
  select.bind(1, visit);
  select.bind(4, std::int64_t{number});
  return select.step() && select.blob(0) == asBytes(hashOf(std::as_bytes(std::span(samples))));
}

std::vector<TraceSample> TraceStore::read(const VisitKey& visit) const {
  Statement select(
      database_,
      "SELECT data, hash, samples, number FROM chunk "
      "WHERE session_id = ? AND step = ? AND attempt = ? ORDER BY number");
  select.bind(1, visit);
  std::vector<TraceSample> samples;
  for (std::int64_t expected = 0; select.step(); ++expected) {
    const auto bytes = select.blob(0);
    const auto count = static_cast<std::size_t>(select.number(2));
    const bool isSound = select.number(3) == expected &&
                         bytes.size() == count * sizeof(TraceSample) &&
                         select.blob(1) == asBytes(hashOf(bytes));
    if (!isSound) {
      throw StorageError(
          message("traces.damaged", database_.path(), expected + 1), StorageError::Kind::Damaged);
    }
    const std::size_t before = samples.size();
    samples.resize(before + count);
    std::memcpy(samples.data() + before, bytes.data(), bytes.size());
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
