#include "study/storage/protocol_repository.h"

#include <algorithm>
#include <array>

#include <sodium.h>

#include "study/model/event_kind.h"
#include "study/storage/hasher.h"
#include "study/storage/statement.h"

namespace study::storage {

std::string sha256(std::string_view bytes) {
  std::array<unsigned char, crypto_hash_sha256_BYTES> hash{};
  crypto_hash_sha256(
      hash.data(), reinterpret_cast<const unsigned char*>(bytes.data()), bytes.size());
  return inHexadecimal(hash);
}

std::string sha256(std::string_view text, const std::vector<protocols::SourceFile>& files) {
  std::vector<std::string> lines;
  for (const auto& file : files) lines.push_back(sha256(file.text) + " " + file.name + "\n");
  std::ranges::sort(lines);
  std::string all = sha256(text) + "\n";
  for (const auto& line : lines) all += line;
  return files.empty() ? sha256(text) : sha256(all);
}

bool isOfLibrary(const protocols::SourceFile& file) {
  return file.name.starts_with(protocols::kLibraryCopyPrefix);
}

bool isSame(const StoredProtocol& stored, const protocols::LoadedProtocol& protocol) {
  return sha256(stored.text, stored.files) == sha256(protocol.text, protocol.files);
}

ProtocolId ProtocolRepository::add(
    const protocols::LoadedProtocol& protocol, const std::string& reason, const std::string& utc) {
  const bool hasForms = std::ranges::any_of(protocol.files, isOfLibrary);
  Statement insert(
      database_,
      "INSERT INTO protocol (sha256, text, reason, added_utc, forms) "
      "VALUES (?, ?, ?, ?, iif(?, 'hashed', NULL))");
  insert.bindAll(sha256(protocol.text, protocol.files), protocol.text, reason, utc, hasForms);
  insert.run();
  const ProtocolId id{database_.lastInsertedId()};
  for (const auto& file : protocol.files) addFile(id, file);
  return id;
}

void ProtocolRepository::addFile(ProtocolId id, const protocols::SourceFile& file) {
  Statement insert(
      database_, "INSERT INTO protocol_file (protocol_id, name, sha256, text) VALUES (?, ?, ?, ?)");
  insert.bindAll(id, file.name, sha256(file.text), file.text);
  insert.run();
}

std::vector<ProtocolId> ProtocolRepository::withoutForms() const {
  Statement select(database_, "SELECT id FROM protocol WHERE forms IS NULL ORDER BY id");
  std::vector<ProtocolId> ids;
  while (select.step()) ids.emplace_back(ProtocolId{select.number(0)});
  return ids;
}

int ProtocolRepository::addForms(ProtocolId id, const std::vector<protocols::SourceFile>& files) {
  const auto stored = load(id).files;
  const auto isThere = [&](const protocols::SourceFile& file) {
    return std::ranges::any_of(stored, [&](const auto& other) { return other.name == file.name; });
  };
  int added = 0;
  for (const auto& file : files) {
    if (!isOfLibrary(file) || isThere(file)) continue;
    addFile(id, file);
    ++added;
  }
  Statement update(database_, "UPDATE protocol SET forms = 'added' WHERE id = ?");
  update.bindAll(id).run();
  return added;
}

std::vector<std::string> ProtocolRepository::changes(ProtocolId id) const {
  auto stored = load(id);
  const auto number = std::to_string(static_cast<std::int64_t>(id));
  std::vector<std::string> changes;
  Statement hashes(
      database_, "SELECT name, sha256 FROM protocol_file WHERE protocol_id = ? ORDER BY name");
  hashes.bindAll(id);
  for (const auto& file : stored.files) {
    if (hashes.step() && hashes.text(1) == sha256(file.text)) continue;
    changes.push_back(
        "'" + file.name + "' of version " + number + " of the protocol is not what its hash says");
  }
  if (stored.areFormsAdded) std::erase_if(stored.files, isOfLibrary);
  if (sha256(stored.text, stored.files) != stored.sha256) {
    changes.push_back("version " + number + " of the protocol is not what its hash says");
  }
  return changes;
}

void ProtocolRepository::freeze(ProtocolId id, const std::string& utc) {
  Statement update(
      database_, "UPDATE protocol SET frozen_utc = ? WHERE id = ? AND frozen_utc IS NULL");
  update.bindAll(utc, id);
  update.run();
}

StoredProtocol ProtocolRepository::load(ProtocolId id) const {
  const bool isOld = !database_.hasColumn("protocol", "forms");  // an older format, opened for
                                                                 // reading only
  Statement select(
      database_,
      std::string("SELECT sha256, text, reason, added_utc, frozen_utc, ") +
          (isOld ? "NULL" : "forms") + " FROM protocol WHERE id = ?");
  select.bindAll(id);
  if (!select.step()) {
    throw StorageError(
        database_.path() + " has lost its protocol. Restore it from a copy.",
        StorageError::Kind::Damaged);
  }
  StoredProtocol protocol{
      .id = id,
      .sha256 = select.text(0),
      .text = select.text(1),
      .reason = select.text(2),
      .addedUtc = select.text(3),
      .frozenUtc = select.optionalText(4),
      .areFormsAdded = select.optionalText(5) == "added",
      .defaults = defaultsOf(id)};
  Statement files(
      database_, "SELECT name, text FROM protocol_file WHERE protocol_id = ? ORDER BY name");
  files.bindAll(id);
  while (files.step()) protocol.files.push_back({files.text(0), files.text(1)});
  return protocol;
}

protocols::Defaults ProtocolRepository::defaultsOf(ProtocolId id) const {
  // The release that stored the first version is in the study's row. For an amendment, the format
  // of its event shows the release: release 0.1 stored a sentence, later releases store values.
  Statement select(
      database_,
      "SELECT CASE WHEN ?1 = (SELECT min(id) FROM protocol) "
      "THEN (SELECT app_version NOT LIKE '0.1.%' FROM study) "
      "ELSE (SELECT detail LIKE '{%' FROM event WHERE kind = ?2 "
      "ORDER BY seq LIMIT 1 OFFSET (SELECT count(*) - 1 FROM protocol WHERE id < ?1)) END");
  select.bindAll(id, nameOf(EventKind::AmendedProtocol));
  const bool isCurrent = select.step() && select.number(0) != 0;
  return isCurrent ? protocols::Defaults::Current : protocols::Defaults::Release01;
}

StoredProtocol ProtocolRepository::current() const {
  const auto ids = all();
  return load(ids.empty() ? ProtocolId{0} : ids.back());
}

bool ProtocolRepository::isAnyFrozen() const {
  return Statement(database_, "SELECT 1 FROM protocol WHERE frozen_utc IS NOT NULL").step();
}

std::vector<ProtocolId> ProtocolRepository::all() const {
  Statement select(database_, "SELECT id FROM protocol ORDER BY id");
  std::vector<ProtocolId> ids;
  while (select.step()) ids.emplace_back(ProtocolId{select.number(0)});
  return ids;
}

}  // namespace study::storage
