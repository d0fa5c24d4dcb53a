#pragma once

#include <optional>
#include <set>
#include <string>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/blinding_secret.h"
#include "study/storage/database.h"
#include "study/storage/keys/sealing_key.h"

namespace study::storage {

/// identity.db: answers that name a person, and what their fingerprints are made with. They are
/// stored apart from everything else and never exported. Names are sealed with the identity key of
/// their participant; the keys are in the same file, and can be sealed with one that a passphrase
/// opens (docs/decisions/0062). Each row carries a hash of itself, because the audit trail must not
/// contain anything about them.
class IdentityStore {
 public:
  explicit IdentityStore(Database database) : database_(std::move(database)) {}

  /// Names are sealed with one key, what the audit trail says of a participant with the other.
  enum class Key { Identity, Content };

  struct Place {
    std::string participant;
    int sessionNumber = 1;
    int step = 0;
    int attempt = 1;
  };

  /// One transaction.
  void put(
      const Place& place, const std::string& item, const std::string& text, const std::string& utc);
  /// One transaction.
  void remove(const Place& place, const std::string& item);
  /// @throws StorageError  if names are locked.
  bool has(const Place& place, const std::string& item) const;

  /// An answer that names a person.
  struct Name {
    std::string participant;
    std::string item;
    std::string text;
  };
  /// All of them, or those of one participant, by participant and item. What is sealed and cannot
  /// be opened is left out; damaged() tells it. @throws StorageError  if names are locked.
  std::vector<Name> names(const std::optional<std::string>& participant = std::nullopt) const;

  /// All answers that name people, each once.
  std::vector<std::string> texts() const;

  /// How many rows there are, of one participant; also while names are locked.
  std::size_t count(const std::string& participant) const;

  /// Draws both keys of a participant. Does nothing if there are keys, or were. One transaction.
  /// @throws StorageError  if names are locked.
  void drawKeys(const std::string& participant);
  bool hasDrawnKeys(const std::string& participant) const;
  /// Draws one key of somebody who took part under an older release: that of names, while the trail
  /// says in the open what they answered, or later that of the trail. Does nothing if there is one.
  /// One transaction. @throws StorageError  if it is that of names, and they are locked.
  void drawMissingKey(Key kind, const std::string& participant);
  /// The content key of somebody whose names are kept elsewhere, inside the caller's transaction.
  void putContentKey(const std::string& participant, const SealingKey& key);
  /// std::nullopt if it was destroyed, or if the participant took part under an older release.
  /// @throws StorageError  if it is that of names, and they are locked.
  std::optional<SealingKey> key(Key kind, const std::string& participant) const;
  /// Destroys a key, with the names if it is theirs. One transaction.
  void destroy(Key kind, const std::string& participant);

  /// Whether a passphrase opens the key with which the keys of names are sealed.
  bool hasPassphrase() const;
  /// Whether that key was not given to the database. Then no name can be read or added.
  bool isLocked() const { return database_.key() == nullptr && hasPassphrase(); }
  /// Whether a name is not sealed: an older release wrote it.
  bool hasUnsealedNames() const;
  /// Seals names that lie in the open although there is a key for them. One transaction. @return
  /// whose they are  @throws StorageError  if names are locked.
  std::set<std::string> sealUnsealedNames();
  /// Seals the keys of names with @p key. Inside the caller's transaction, which stores the key
  /// behind its passphrase, too; then it is given to the database.
  void sealKeysWith(const SealingKey& key);

  /// One transaction. @throws StorageError  if there is one already.
  void put(const BlindingSecret& secret);
  /// std::nullopt if a station keeps it, and in studies that an older release made.
  std::optional<BlindingSecret> blindingSecret() const;

  /// What fingerprints of these rows are made with, if the secret is not here. One transaction.
  void storeFingerprintSecret(const BlindingSecret& secret);
  std::optional<BlindingSecret> secretOfFingerprints() const;

  /// The rows that differ from what was written, or cannot be opened, by participant and item.
  /// (Format 1 stored no hash.) While names are locked, opening is not tried.
  std::vector<std::string> damaged() const;

  Database& database() noexcept { return database_; }

 private:
  Database database_;
};

}  // namespace study::storage
