#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// The exclusive right of one program and window to run a session. The destructor ends it. The
/// lease of a crashed program on this computer, or one whose row could not be removed, is taken
/// over, even if the computer was renamed since. This computer cannot check whether a program on
/// another computer is still running: its lease is taken over only on request, and the operator is
/// shown when the session last stored an event.
class Lease {
 public:
  /// Which leases may be taken over: those of programs that ended on this computer, or of other
  /// computers, too.
  enum class From { EndedPrograms, OtherComputersToo };

  /// Takes the lease, inside the caller's transaction.
  /// @throws StorageError  (Busy) if another program holds the lease; names the computer and
  ///     process.
  Lease(
      Database& database,
      SessionId session,
      const std::string& utc,
      From from = From::EndedPrograms);
  ~Lease();

  /// The program that holds a session's lease, or held it when it ended.
  struct Holder {
    std::string station;   ///< name of the computer
    std::int64_t pid = 0;  ///< process number on that computer
    std::string since;     ///< UTC time of taking the lease
    bool isAlive = false;  ///< whether the program is running; assumed if it is on another computer
    bool isOnThisComputer = false;  ///< then isAlive is certain
    bool isOfThisBoot = false;      ///< whether this computer was not restarted since, so that its
                                    ///< monotonic clock continued
  };
  /// The present holder; std::nullopt if there is none. Does not take the lease.
  static std::optional<Holder> holder(const Database& database, SessionId session);

  /// Removes all leases, because no session runs in a copy of a study.
  static void clear(Database& database);

  /// @throws StorageError  if another program has taken the lease over.
  void requireHeld() const;

  Lease(Lease&& other) noexcept;
  Lease& operator=(Lease&&) = delete;

 private:
  Database* database_;
  SessionId session_;
  std::string token_;  ///< unique to this lease
};

}  // namespace study::storage
