#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// A protocol as a study stores it, complete with its files, so that it does not depend on files
/// elsewhere.
struct StoredProtocol {
  ProtocolId id{};
  std::string sha256;  ///< of the text and all files but those of areFormsAdded, hexadecimal
  std::string text;
  std::vector<protocols::SourceFile> files;
  std::string reason;
  std::string addedUtc;
  std::optional<std::string> frozenUtc;
  /// Whether copies of the library's forms were added later, because an older release stored the
  /// protocol without them.
  bool areFormsAdded = false;
  protocols::Defaults defaults = protocols::Defaults::Current;  ///< of the release that stored it
};

/// Whether @p stored equals @p protocol, byte for byte with all files.
bool isSame(const StoredProtocol& stored, const protocols::LoadedProtocol& protocol);

/// The tables of protocols and their files.
class ProtocolRepository {
 public:
  explicit ProtocolRepository(Database& database) : database_(database) {}

  /// Inside the caller's transaction.
  ProtocolId add(
      const protocols::LoadedProtocol& protocol, const std::string& reason, const std::string& utc);
  void freeze(ProtocolId id, const std::string& utc);

  /// The versions whose forms of the library were not copied yet (docs/decisions/0073).
  std::vector<ProtocolId> withoutForms() const;
  /// Adds the copies among @p files to a version that has none, inside the caller's transaction.
  /// @return how many
  int addForms(ProtocolId id, const std::vector<protocols::SourceFile>& files);

  /// The parts of a version (its text, its files) that do not match their hashes.
  std::vector<std::string> changes(ProtocolId id) const;

  /// @throws StorageError  if there is none with that id.
  StoredProtocol load(ProtocolId id) const;
  /// The newest one, which new sessions use.
  StoredProtocol current() const;
  std::vector<ProtocolId> all() const;

  /// The defaults of the release under which the protocol came into the study.
  protocols::Defaults defaultsOf(ProtocolId id) const;

 private:
  void addFile(ProtocolId id, const protocols::SourceFile& file);

  Database& database_;
};

/// SHA-256 in hexadecimal.
std::string sha256(std::string_view bytes);

/// The SHA-256 of a protocol with all its files. Their order does not matter.
std::string sha256(std::string_view text, const std::vector<protocols::SourceFile>& files);

}  // namespace study::storage
