#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>

#include "protocols/model/loaded_protocol.h"
#include "study/model/clock.h"
#include "study/model/ids.h"
#include "study/model/run_mode.h"
#include "study/storage/blinding_secret.h"
#include "study/storage/database.h"
#include "study/storage/event_log.h"
#include "study/storage/evidence/trail_signer.h"
#include "study/storage/identity_store.h"
#include "study/storage/map/study_keys.h"
#include "study/storage/protocol_repository.h"
#include "study/storage/session_repository.h"
#include "study/storage/trace_store.h"

namespace study {

/// A study on disk: a folder with study.db, traces.db and identity.db.
///
/// Owns the database connections of the thread that created it. Must outlive its sessions.
class Study {
 public:
  /// Makes a new folder.
  /// @throws storage::StorageError  if the folder exists already or cannot be written.
  /// @param seed  seed of all random draws; std::nullopt: the protocol's seed, or a random one.
  /// @param secret  blinding secret; std::nullopt: a random one. Given when a station is enrolled,
  ///     and in tests that need known codes and orders.
  /// @param station  where the study's sessions take place; Station::isNone(): a study of one
  ///     machine.
  /// @param uuid  permanent name of the study; empty: derived from secret, seed and protocol
  static Study create(
      const std::filesystem::path& folder,
      const protocols::LoadedProtocol& protocol,
      Clock& clock,
      std::optional<std::uint64_t> seed = std::nullopt,
      const std::optional<storage::BlindingSecret>& secret = std::nullopt,
      const Station& station = {},
      const std::string& uuid = {});

  /// Opens an existing folder. Finishes interrupted erasures first, also with Access::ReadOnly.
  /// @throws storage::StorageError
  static Study open(
      const std::filesystem::path& folder,
      Clock& clock,
      storage::Database::Access access = storage::Database::Access::ReadWrite);
  /// As above, with the clocks of this computer.
  static Study open(
      const std::filesystem::path& folder,
      storage::Database::Access access = storage::Database::Access::ReadWrite);

  const std::filesystem::path& folder() const noexcept { return folder_; }
  const std::string& uuid() const noexcept { return uuid_; }
  std::uint64_t seed() const noexcept { return seed_; }

  /// The secret that hides the conditions in sessions of @p mode; nullptr for simulated sessions,
  /// which need no blinding, and in studies of release 0.1.
  /// @throws storage::StorageError  if the secret is not this study's, or is not available on this
  ///     computer; what() says what to do.
  const storage::BlindingSecret* secretFor(RunMode mode);

  /// Whether the conditions of live and pilot sessions are sealed with a key that is not in the
  /// study's folder (docs/decisions/0049).
  bool isSealed() const noexcept { return isSealed_; }

  /// Whether sealed conditions can be read: this station has the key, or unlock() or useKey() has
  /// set it.
  bool hasKey() const noexcept { return database_.key() != nullptr; }

  /// Whether the study's key can be opened with a passphrase.
  bool hasPassphrase() const { return storage::wrappedKeyIn(database_).has_value(); }

  /// Opens the study's key with its passphrase; this program then holds the key until it ends.
  /// @return false if the passphrase is wrong
  bool unlock(const std::string& passphrase);

  /// Uses an exported key. @throws UserError  if it is the key of another study.
  void useKey(const storage::BlindingSecret& key);

  /// Opens the key that seals names with the passphrase of names (docs/decisions/0062); this
  /// program then holds the key until it ends. @return false if the passphrase is wrong
  bool unlockNames(const std::string& passphrase);

  /// The secret for the fingerprints of identity.db in the audit trail; std::nullopt if the study
  /// has none. @throws storage::StorageError
  std::optional<storage::BlindingSecret> fingerprintSecret();

  const std::string& createdUtc() const noexcept { return createdUtc_; }
  Clock& clock() noexcept { return *clock_; }

  /// The station where its sessions take place; Station::isNone() in a study of one machine and in
  /// a collected study.
  const Station& station() const noexcept { return station_; }

  /// Whether the study was collected from several stations (CollectedStudy). Such a study can be
  /// evaluated and exported; its sessions can be continued at their stations only.
  bool isCollected() const noexcept { return isCollected_; }

  /// The protocol that new sessions use, or the given version of it.
  const protocols::LoadedProtocol& protocol();
  const protocols::LoadedProtocol& protocol(ProtocolId id);

  /// New sessions use @p protocol from now on. Once a live participant has begun, this needs a
  /// reason.
  /// @throws storage::StorageError  if the required reason is missing.
  void amend(const protocols::LoadedProtocol& protocol, const std::string& reason);

  storage::Database& database() noexcept { return database_; }
  storage::ProtocolRepository protocols() { return storage::ProtocolRepository(database_); }
  storage::SessionRepository sessions() { return storage::SessionRepository(database_); }
  storage::EventLog events() { return storage::EventLog(database_, &identities_); }
  storage::TraceStore& traces() noexcept { return traces_; }
  storage::IdentityStore& identities() noexcept { return identities_; }

  /// Another connection to traces.db, for the recorder's thread.
  storage::TraceStore openTraces() const;

  /// Runs @p action. If the disk is full, frees the reserved disk space and runs @p action once
  /// more.
  /// @throws everything that @p action throws.
  void retryWithReservedSpace(const std::function<void()>& action);

  /// Runs @p action in one transaction; frees the reserved disk space if the disk is full. The last
  /// change of the action must be an appended event. If a commit reports an error, the audit trail
  /// is read to find out whether the event was written.
  /// @throws storage::StorageError  nothing has changed, except after the kind Unknown, when it is
  ///     not known.
  void transact(const std::function<void()>& action);

  /// Signs the audit trail with the key of this station. Must be the last change in the action of
  /// transact(). @param purpose  name of the kind of the event that causes the signature
  void signTrail(std::string_view purpose);

  /// Whether the study was opened for writing.
  bool isWritable() const noexcept { return isWritable_; }

  /// Appends an event without a session, such as an export or an unblinding, in its own
  /// transaction, and signs the audit trail.
  void note(EventKind kind, const std::string& words);
  void note(storage::Event event);

 private:
  Study(
      std::filesystem::path folder,
      Clock& clock,
      storage::Database database,
      storage::Database traces,
      storage::Database identities);
  void readStudyRow();
  void readSecret();
  /// Sets the keys of conditions and names that are available without a passphrase.
  void findKey() noexcept;
  void setKey();
  /// Copies forms of the library into protocol versions that an older release stored without them.
  void copyForms();
  bool isEventStored(const std::vector<std::byte>& head);

  std::filesystem::path folder_;
  Clock* clock_;
  storage::Database database_;
  storage::TraceStore traces_;
  storage::IdentityStore identities_;
  std::map<ProtocolId, std::unique_ptr<protocols::LoadedProtocol>> loaded_;
  std::string uuid_;
  std::uint64_t seed_ = 0;
  std::string createdUtc_;
  storage::TrailSigner signer_;
  Station station_;
  bool isCollected_ = false;
  bool isWritable_ = true;
  bool isSecretRead_ = false;
  bool isSealed_ = false;
  std::optional<storage::BlindingSecret> secret_;
};

/// A random seed below 2^53, so that JSON files and scripts can represent it exactly.
std::uint64_t randomSeed();

/// The version of this program; it is stored with every session.
std::string_view appVersion() noexcept;

/// Writes @p protocol as the new file @p path, and the files that it names beside it. A file that
/// is there already with the same content stays. The forms of the library are not written.
/// @throws storage::StorageError  if another file is in the way; nothing is overwritten.
void saveProtocol(const protocols::LoadedProtocol& protocol, const std::string& path);

}  // namespace study
