#include "study/storage/trace_store.h"

#include <array>
#include <bit>
#include <cstring>

#include <sodium.h>

#include "study/storage/statement.h"
#include "study/storage/transaction.h"

namespace study::storage {
namespace {

constexpr std::int64_t kLayout = 1;
static_assert(sizeof(TraceSample) == 28, "as documented");
static_assert(
    std::endian::native == std::endian::little, "samples are written as they lie in memory");

using Hash = std::array<std::byte, 32>;

Hash hashOf(std::span<const std::byte> bytes) {
  Hash hash{};
  crypto_generichash(
      reinterpret_cast<unsigned char*>(hash.data()),
      hash.size(),
      reinterpret_cast<const unsigned char*>(bytes.data()),
      bytes.size(),
      nullptr,
      0);
  return hash;
}

void bindVisit(Statement& statement, const VisitKey& visit) {
  statement.bind(1, static_cast<std::int64_t>(visit.session))
      .bind(2, std::int64_t{visit.step})
      .bind(3, std::int64_t{visit.attempt});
}

}  // namespace

void TraceStore::add(const VisitKey& visit, int number, const std::vector<TraceSample>& samples) {
  const auto bytes = std::as_bytes(std::span(samples));
  const Hash hash = hashOf(bytes);
  Transaction transaction(database_);
  Statement insert(
      database_,
      "INSERT INTO chunk (session_id, step, attempt, number, samples, layout, data, hash) "
      "VALUES (?,?,?,?,?,?,?,?)");
  bindVisit(insert, visit);
  insert.bind(4, std::int64_t{number})
      .bind(5, static_cast<std::int64_t>(samples.size()))
      .bind(6, kLayout)
      .bind(7, bytes)
      .bind(8, std::span<const std::byte>(hash));
  insert.run();
  transaction.commit();
}

std::vector<TraceSample> TraceStore::read(const VisitKey& visit) const {
  Statement select(
      database_,
      "SELECT data, hash, samples, number FROM chunk "
      "WHERE session_id = ? AND step = ? AND attempt = ? ORDER BY number");
  bindVisit(select, visit);
  std::vector<TraceSample> samples;
  for (std::int64_t expected = 0; select.step(); ++expected) {
    const auto bytes = select.blob(0);
    const auto count = static_cast<std::size_t>(select.number(2));
    const Hash hash = hashOf(bytes);
    const bool isSound = select.number(3) == expected &&
                         bytes.size() == count * sizeof(TraceSample) &&
                         select.blob(1) == std::vector<std::byte>(hash.begin(), hash.end());
    if (!isSound) {
      throw StorageError(
          database_.path() + " is damaged: second " + std::to_string(expected + 1) +
              " of a trial is not what was recorded.",
          StorageError::Kind::Damaged);
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
  bindVisit(select, visit);
  select.step();
  return select.number(0);
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
