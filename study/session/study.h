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
#include "study/storage/database.h"
#include "study/storage/event_log.h"
#include "study/storage/identity_store.h"
#include "study/storage/protocol_repository.h"
#include "study/storage/session_repository.h"
#include "study/storage/trace_store.h"

namespace study {

/// A study on disk: a folder with study.db, traces.db and identity.db.
///
/// Owns the connections of the thread that made it. Outlives its sessions.
class Study {
 public:
  /// A new folder. @throws storage::StorageError  if it is there already, or cannot be written.
  /// @param seed  of everything drawn; the protocol's, or one drawn now, where there is none.
  static Study create(
      const std::filesystem::path& folder,
      const protocols::LoadedProtocol& protocol,
      Clock& clock,
      std::optional<std::uint64_t> seed = std::nullopt);

  /// A folder that is there. @throws storage::StorageError
  static Study open(
      const std::filesystem::path& folder,
      Clock& clock,
      storage::Database::Access access = storage::Database::Access::ReadWrite);

  const std::filesystem::path& folder() const noexcept { return folder_; }
  const std::string& uuid() const noexcept { return uuid_; }
  std::uint64_t seed() const noexcept { return seed_; }
  const std::string& createdUtc() const noexcept { return createdUtc_; }
  Clock& clock() noexcept { return *clock_; }

  /// The protocol that new sessions use, and that of a session.
  const protocols::LoadedProtocol& protocol();
  const protocols::LoadedProtocol& protocol(ProtocolId id);

  /// New sessions use @p protocol from now on. Once a live participant has begun, that is a new
  /// version, and needs a reason. @throws storage::StorageError  if it does and there is none.
  void amend(const protocols::LoadedProtocol& protocol, const std::string& reason);

  storage::Database& database() noexcept { return database_; }
  storage::ProtocolRepository protocols() { return storage::ProtocolRepository(database_); }
  storage::SessionRepository sessions() { return storage::SessionRepository(database_); }
  storage::EventLog events() { return storage::EventLog(database_); }
  storage::TraceStore& traces() noexcept { return traces_; }
  storage::IdentityStore& identities() noexcept { return identities_; }

  /// Another connection to traces.db, for the recorder's thread.
  storage::TraceStore openTraces() const;

  /// Runs @p action; if the disk is full, gives back the room that was kept free and tries once
  /// more.
  /// @throws whatever it throws.
  void withRoom(const std::function<void()>& action);

  /// Runs @p action, which notes at least one event at its end, as one transaction, with that room
  /// where it is needed. A commit that failed is unknown, not undone: the audit trail says whether
  /// it arrived.
  /// @throws storage::StorageError  and then nothing has changed; or, of the kind Unknown, it may
  /// have.
  void transact(const std::function<void()>& action);

  /// Writes down something that happened to no session: an export, an unblinding.
  void note(const std::string& kind, const std::string& words);
  void note(storage::Event event);

 private:
  Study(
      std::filesystem::path folder,
      Clock& clock,
      storage::Database database,
      storage::Database traces,
      storage::Database identities);
  void readHead();
  bool hasArrived(const std::vector<std::byte>& head);

  std::filesystem::path folder_;
  Clock* clock_;
  storage::Database database_;
  storage::TraceStore traces_;
  storage::IdentityStore identities_;
  std::map<ProtocolId, std::unique_ptr<protocols::LoadedProtocol>> loaded_;
  std::string uuid_;
  std::uint64_t seed_ = 0;
  std::string createdUtc_;
};

/// The version of this program, as it stands in every session.
std::string_view appVersion() noexcept;

}  // namespace study
