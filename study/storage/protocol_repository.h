#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocols/model/loaded_protocol.h"
#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// A version of the protocol as a study stores it: complete with its files, so that it does not
/// depend on other files.
struct StoredProtocol {
  ProtocolId id{};
  std::string sha256;  ///< hexadecimal, of the text and all files except forms added later
  std::string text;
  std::vector<protocols::SourceFile> files;
  std::string reason;  ///< why this version was added
  std::string addedUtc;
  std::optional<std::string> frozenUtc;
  /// Whether copies of the library's forms were added later, because an older release had stored
  /// the protocol without them.
  bool areFormsAdded = false;
  protocols::Defaults defaults = protocols::Defaults::Current;  ///< of the release that stored it
};

/// Whether @p stored and @p protocol have the same text and the same files, byte for byte.
bool isSame(const StoredProtocol& stored, const protocols::LoadedProtocol& protocol);

/// The tables of protocols and their files.
class ProtocolRepository {
 public:
  explicit ProtocolRepository(Database& database) : database_(database) {}

  /// Inserts a version, inside the caller's transaction.
  ProtocolId add(
      const protocols::LoadedProtocol& protocol, const std::string& reason, const std::string& utc);
  /// Records that a live participant has begun with this version.
  void freeze(ProtocolId id, const std::string& utc);

  /// The versions that were stored without copies of the library's forms, and for which addForms()
  /// was not called since (docs/decisions/0073).
  std::vector<ProtocolId> withoutForms() const;
  /// Adds those of @p files that are copies of the library's forms to a version without forms,
  /// inside the caller's transaction. @return their number
  int addForms(ProtocolId id, const std::vector<protocols::SourceFile>& files);

  /// The parts of a version (text, files) whose hash does not match.
  std::vector<std::string> changes(ProtocolId id) const;

  /// @throws StorageError  if there is no version with that id.
  StoredProtocol load(ProtocolId id) const;
  /// The newest version, which new sessions use.
  StoredProtocol current() const;
  std::vector<ProtocolId> all() const;
  /// Whether a live participant has begun with any version.
  bool isAnyFrozen() const;

  /// The defaults of the release that stored the version.
  protocols::Defaults defaultsOf(ProtocolId id) const;

 private:
  void addFile(ProtocolId id, const protocols::SourceFile& file);

  Database& database_;
};

/// SHA-256 in hexadecimal.
std::string sha256(std::string_view bytes);

/// The SHA-256 of a protocol with all its files, independent of their order.
std::string sha256(std::string_view text, const std::vector<protocols::SourceFile>& files);

}  // namespace study::storage
