#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// The exclusive right to run a session, for one program and one window. The destructor gives it
/// back. A lease that a crashed program of this computer left, or that could not be given back, is
/// taken over, also if the computer has got another name since. Whether a program on another
/// computer is still running cannot be seen from here: its lease is taken over only on request, and
/// the operator is shown when the session last stored something.
class Lease {
 public:
  enum class From { EndedPrograms, OtherComputersToo };

  /// Takes the lease, inside the caller's transaction.
  /// @throws StorageError  (Busy) if the session is running elsewhere; says where.
  Lease(
      Database& database,
      SessionId session,
      const std::string& utc,
      From from = From::EndedPrograms);
  ~Lease();

  /// The program that holds a session's lease.
  struct Holder {
    std::string station;   ///< computer
    std::int64_t pid = 0;  ///< process there
    std::string since;     ///< UTC
    bool isAlive = false;  ///< false: that program ended without giving the lease back
    bool isHere = false;   ///< on this computer: then isAlive is certain
    bool isOfThisBoot =
        false;  ///< this computer was not restarted since: its monotonic clock went on
  };
  /// The present holder, without taking the lease; std::nullopt if there is none.
  static std::optional<Holder> holder(const Database& database, SessionId session);

  /// Removes the leases of all programs: in a copy of a study no session runs.
  static void clear(Database& database);

  /// @throws StorageError  (Busy) if another program took it over meanwhile.
  void requireHeld() const;

  Lease(Lease&& other) noexcept;
  Lease& operator=(Lease&&) = delete;

 private:
  Database* database_;
  SessionId session_;
  std::string token_;  ///< unique to this lease
};

}  // namespace study::storage
