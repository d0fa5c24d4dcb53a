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
/// apart from all other data and never exported. Names are sealed with the Identity key of their
/// participant; the keys are in the same file, and can be sealed in turn with a key that a
/// passphrase opens (docs/decisions/0062). Each row has a hash of itself, because the audit trail
/// must not contain unkeyed hashes of names.
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

    /// The name of the row of an answer, which is also the associated data of its sealed text.
    std::string rowOf(const std::string& item) const;
  };

  /// Inserts or replaces an answer in one transaction. @throws StorageError  if names are locked.
  void put(
      const Place& place, const std::string& item, const std::string& text, const std::string& utc);
  /// Deletes an answer in one transaction.
  void remove(const Place& place, const std::string& item);
  /// Deletes all answers of a participant's session in one transaction.
  void removeSession(const std::string& participant, int sessionNumber);
  /// Whether the answer is stored. @throws StorageError  if names are locked.
  bool has(const Place& place, const std::string& item) const;

  /// An answer that names a person.
  struct Name {
    std::string participant;
    std::string item;
    std::string text;
  };
  /// All names, or those of one participant, by participant and item. Rows that cannot be unsealed
  /// are left out; damaged() lists them. @throws StorageError  if names are locked.
  std::vector<Name> names(const std::optional<std::string>& participant = std::nullopt) const;

  /// All answers that name people, without duplicates.
  std::vector<std::string> texts() const;

  /// The number of rows of a participant; also works while names are locked.
  std::size_t count(const std::string& participant) const;

  /// Draws both keys of a participant in one transaction. Does nothing if they were drawn before,
  /// even if they have been destroyed since.
  /// @throws StorageError  if names are locked.
  void drawKeys(const std::string& participant);
  bool hasDrawnKeys(const std::string& participant) const;
  /// Draws one key of a participant of an older release in one transaction: Identity while the
  /// trail is still unsealed, or Content when the trail is sealed. Does nothing if the participant
  /// has that key.
  /// @throws StorageError  if @p kind is Identity and names are locked.
  void drawMissingKey(Key kind, const std::string& participant);
  /// Stores a participant's content key that was copied from a station; the names stay in the
  /// station's file. Inside the caller's transaction.
  void putContentKey(const std::string& participant, const SealingKey& key);
  /// std::nullopt if the key was destroyed, or never drawn (participants of older releases).
  /// @throws StorageError  if @p kind is Identity and names are locked.
  std::optional<SealingKey> key(Key kind, const std::string& participant) const;
  /// Destroys a key, and with the Identity key also the names, in one transaction.
  void destroy(Key kind, const std::string& participant);

  /// Whether the keys of names are sealed with a key that a passphrase opens.
  bool hasPassphrase() const;
  /// Whether the keys of names are sealed and the database has no key for them. Then no name can be
  /// read or added.
  bool isLocked() const { return database_.key() == nullptr && hasPassphrase(); }
  /// Whether an older release stored a name that is not sealed.
  bool hasUnsealedNames() const;
  /// Seals unsealed names of participants who have an Identity key, in one transaction. @return the
  /// codes of these participants
  /// @throws StorageError  if names are locked.
  std::set<std::string> sealUnsealedNames();
  /// Seals the Identity keys with @p key, inside the caller's transaction. The caller must also
  /// store @p key wrapped with the passphrase, and afterwards set it as the database's key.
  void sealKeysWith(const SealingKey& key);

  /// Stores the blinding secret in one transaction. @throws StorageError  if there is one already.
  void put(const BlindingSecret& secret);
  /// std::nullopt if a station stores the secret, and in studies of releases without a secret.
  std::optional<BlindingSecret> blindingSecret() const;

  /// Stores the secret for fingerprints of the rows, in studies whose blinding secret is stored by
  /// a station. One transaction.
  void storeFingerprintSecret(const BlindingSecret& secret);
  std::optional<BlindingSecret> fingerprintSecret() const;

  /// The rows that differ from what was written or cannot be unsealed, by participant and item.
  /// Rows of format 1 have no hash. While names are locked, sealed rows are not opened.
  std::vector<std::string> damaged() const;

  Database& database() noexcept { return database_; }

 private:
  Database database_;
};

}  // namespace study::storage
