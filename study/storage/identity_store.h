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

/// identity.db: answers that name a person, and the secret for their fingerprints. They are stored
/// apart from everything else and never exported. Names are sealed with the identity key of their
/// participant; the keys are in the same file, and can themselves be sealed with a key that a
/// passphrase opens (docs/decisions/0062). Each row carries a hash of itself, because the audit
/// trail must not contain anything about them.
class IdentityStore {
 public:
  explicit IdentityStore(Database database) : database_(std::move(database)) {}

  /// The two keys of a participant: Identity seals names, Content seals details in the audit trail.
  enum class Key { Identity, Content };

  /// The step and attempt in which an answer was given.
  struct Place {
    std::string participant;
    int sessionNumber = 1;
    int step = 0;     ///< from 0
    int attempt = 1;  ///< from 1
  };

  /// Writes an answer, or replaces it. One transaction. @throws StorageError  if names are locked.
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
  /// All of them, or those of one participant, by participant and item. Rows that cannot be opened
  /// are left out; damaged() lists them. @throws StorageError  if names are locked.
  std::vector<Name> names(const std::optional<std::string>& participant = std::nullopt) const;

  /// All answers that name people, each once.
  std::vector<std::string> texts() const;

  /// The number of rows of a participant; also works while names are locked.
  std::size_t count(const std::string& participant) const;

  /// Draws both keys of a participant. Does nothing if they were drawn before, even if they were
  /// destroyed since. One transaction.
  /// @throws StorageError  if names are locked.
  void drawKeys(const std::string& participant);
  bool hasDrawnKeys(const std::string& participant) const;
  /// Draws one key of a participant of an older release: Identity while the trail is still
  /// unsealed, or Content when the trail is sealed. Does nothing if there is one. One transaction.
  /// @throws StorageError  if @p kind is Identity and names are locked.
  void drawMissingKey(Key kind, const std::string& participant);
  /// Stores a participant's content key that came from a station, whose own file keeps the names.
  /// Inside the caller's transaction.
  void putContentKey(const std::string& participant, const SealingKey& key);
  /// std::nullopt if it was destroyed, or never drawn (participants of older releases).
  /// @throws StorageError  if @p kind is Identity and names are locked.
  std::optional<SealingKey> key(Key kind, const std::string& participant) const;
  /// Destroys a key; with the Identity key also the names. One transaction.
  void destroy(Key kind, const std::string& participant);

  /// Whether a passphrase opens the key with which the keys of names are sealed.
  bool hasPassphrase() const;
  /// Whether there is such a passphrase, and its key was not given to the database. Then no name
  /// can be read or added.
  bool isLocked() const { return database_.key() == nullptr && hasPassphrase(); }
  /// Whether a name is not sealed: an older release wrote it.
  bool hasUnsealedNames() const;
  /// Seals unsealed names of participants who have an Identity key. One transaction. @return the
  /// codes of these participants @throws StorageError  if names are locked.
  std::set<std::string> sealUnsealedNames();
  /// Seals the Identity keys with @p key, inside the caller's transaction. The caller also stores
  /// @p key wrapped with the passphrase, and afterwards gives it to the database.
  void sealKeysWith(const SealingKey& key);

  /// One transaction. @throws StorageError  if there is one already.
  void put(const BlindingSecret& secret);
  /// std::nullopt if a station keeps it, and in studies of releases without such a secret.
  std::optional<BlindingSecret> blindingSecret() const;

  /// Stores the secret for fingerprints of these rows, for studies whose blinding secret a station
  /// keeps. One transaction.
  void storeFingerprintSecret(const BlindingSecret& secret);
  std::optional<BlindingSecret> fingerprintSecret() const;

  /// The rows that differ from what was written, or cannot be opened, by participant and item.
  /// (Format 1 stored no hash.) While names are locked, opening is not tried.
  std::vector<std::string> damaged() const;

  Database& database() noexcept { return database_; }

 private:
  Database database_;
};

}  // namespace study::storage
