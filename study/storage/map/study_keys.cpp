#include "study/storage/map/study_keys.h"

#include <algorithm>
#include <fstream>
#include <map>
#include <mutex>
#include <span>
#include <sstream>

#include <fmt/format.h>

#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/storage/hasher.h"
#include "study/storage/statement.h"
#include "study/storage/station_store.h"

namespace study::storage {
namespace {

constexpr const char* kListName = "study-keys";
constexpr const char* kFirstLine = "palpate study key 1";
constexpr std::string_view kKeyWord = "key ";

std::optional<BlindingSecret> keyFrom(std::string_view hexadecimal) {
  const auto bytes = fromHexadecimal<BlindingSecret::Bytes>(hexadecimal);
  return bytes ? std::optional(BlindingSecret(*bytes)) : std::nullopt;
}

/// The key in a line "COMMITMENT KEY FOLDER", if the line has that commitment.
std::optional<BlindingSecret> keyIn(const std::string& line, const std::string& commitment) {
  std::istringstream words(line);
  std::string committed;
  std::string hexadecimal;
  if (!(words >> committed >> hexadecimal) || committed != commitment) return std::nullopt;
  auto key = keyFrom(hexadecimal);
  return key && key->commitment() == commitment ? key : std::nullopt;
}

std::optional<BlindingSecret> keyOnStation(const std::string& commitment) {
  const auto station = StationStore::find(StationStore::defaultFolder());
  if (!station) return std::nullopt;
  for (const auto& line : station->lines(kListName)) {
    if (auto key = keyIn(line, commitment)) return key;
  }
  return std::nullopt;
}

/// The keys that this program holds in memory, by commitment (key of a study) or salt (key of
/// names). Used by several threads.
struct CachedKeys {
  std::mutex mutex;
  std::map<std::string, BlindingSecret> keys;
};

CachedKeys& cachedKeys() {
  static CachedKeys held;
  return held;
}

/// The salt of a wrapped key: 128 random bits that identify it.
std::string saltOf(const WrappedKey& wrapped) {
  return {wrapped.salt.begin(), wrapped.salt.end()};
}

}  // namespace

void cacheStudyKey(const BlindingSecret& key) {
  const std::scoped_lock lock(cachedKeys().mutex);
  cachedKeys().keys.insert_or_assign(key.commitment(), key);
}

void cacheNamesKey(const WrappedKey& wrapped, const SealingKey::Bytes& key) {
  const std::scoped_lock lock(cachedKeys().mutex);
  cachedKeys().keys.insert_or_assign(saltOf(wrapped), BlindingSecret(key));
}

std::optional<SealingKey> cachedNamesKey(const WrappedKey& wrapped) {
  const std::scoped_lock lock(cachedKeys().mutex);
  const auto held = cachedKeys().keys.find(saltOf(wrapped));
  if (held == cachedKeys().keys.end()) return std::nullopt;
  return SealingKey(held->second.bytes());
}

void clearCachedKeys() {
  const std::scoped_lock lock(cachedKeys().mutex);
  cachedKeys().keys.clear();
}

bool storeStudyKey(const BlindingSecret& key, const std::filesystem::path& folder) {
  const auto commitment = key.commitment();
  if (keyOnStation(commitment)) return false;
  const auto station = StationStore::openOrCreate(StationStore::defaultFolder());
  std::string where = std::filesystem::absolute(folder).string();
  std::ranges::replace(where, '\n', ' ');
  station.append(kListName, commitment + " " + inHexadecimal(key.bytes()) + " " + where);
  return true;
}

std::optional<BlindingSecret> findStudyKey(const std::string& commitment) {
  {
    const std::scoped_lock lock(cachedKeys().mutex);
    const auto held = cachedKeys().keys.find(commitment);
    if (held != cachedKeys().keys.end()) return held->second;
  }
  return keyOnStation(commitment);
}

bool dropKey(const std::string& commitment) {
  {
    const std::scoped_lock lock(cachedKeys().mutex);
    cachedKeys().keys.erase(commitment);
  }
  const auto station = StationStore::find(StationStore::defaultFolder());
  if (!station) return false;
  auto lines = station->lines(kListName);
  const auto isOfStudy = [&](const std::string& line) {
    return line.starts_with(commitment + " ");
  };
  const auto removed = std::erase_if(lines, isOfStudy);
  if (removed > 0) station->rewrite(kListName, lines);
  return removed > 0;
}

void writeKeyFile(const std::string& path, const BlindingSecret& key, const std::string& title) {
  std::string words = title;
  std::ranges::replace_if(
      words, [](char c) { return static_cast<unsigned char>(c) < ' '; }, ' ');
  writeNewFile(
      path,
      fmt::format(
          "{}\n{}{}\nstudy {}\n"
          "Who has this file can say which condition each alternative was. Hand it over in "
          "person, and keep a copy apart from the study: it cannot be made again.\n",
          kFirstLine,
          kKeyWord,
          inHexadecimal(key.bytes()),
          words));
}

BlindingSecret readKeyFile(const std::string& path) {
  std::ifstream stream(path);
  std::string first;
  std::string second;
  const bool isRead = stream && std::getline(stream, first) && std::getline(stream, second);
  if (isRead && first == kFirstLine && second.starts_with(kKeyWord)) {
    if (auto key = keyFrom(second.substr(kKeyWord.size()))) return *key;
  }
  throw UserError(
      path +
      " holds no key of a study, or cannot be read. 'palpate study key export' writes such a "
      "file.");
}

void storeWrapped(Database& study, const WrappedKey& key) {
  study.execute("DELETE FROM wrapped_key");
  Statement insert(
      study,
      "INSERT INTO wrapped_key (id, salt, operations, memory, sealed) VALUES (1, ?, ?, ?, ?)");
  insert.bindAll(
      std::as_bytes(std::span(key.salt)), key.cost.operations, key.cost.memory, key.sealed);
  insert.run();
}

std::optional<WrappedKey> wrappedKeyIn(const Database& study) {
  // A file of an older format that was opened for reading only lacks the table.
  if (!study.hasTable("wrapped_key")) return std::nullopt;
  Statement select(study, "SELECT salt, operations, memory, sealed FROM wrapped_key WHERE id = 1");
  if (!select.step()) return std::nullopt;
  WrappedKey key{
      .cost =
          {.operations = static_cast<std::uint64_t>(select.number(1)),
           .memory = static_cast<std::uint64_t>(select.number(2))},
      .sealed = select.blob(3)};
  const auto salt = fixedBytes<decltype(key.salt)>(select.blob(0));
  if (!salt) return std::nullopt;
  key.salt = *salt;
  return key;
}

}  // namespace study::storage
