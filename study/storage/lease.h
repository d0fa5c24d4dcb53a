#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// The right to run a session: one program at a time, and one window of it. Given back when this
/// object goes; what a crashed program of this computer left behind is taken over, and so is what
/// this program could not give back.
class Lease {
 public:
  /// Inside the caller's transaction.
  /// @throws StorageError  (Busy) if somebody is running this session; says who.
  Lease(Database& database, SessionId session, const std::string& utc);
  ~Lease();

  /// Who has a session, without taking it.
  struct Holder {
    std::string station;   ///< computer
    std::int64_t pid = 0;  ///< process there
    std::string since;     ///< UTC
    bool isAlive = false;  ///< otherwise that program ended without giving it back
  };
  /// Nothing where nobody has.
  static std::optional<Holder> holder(const Database& database, SessionId session);

  Lease(Lease&& other) noexcept;
  Lease& operator=(Lease&&) = delete;

 private:
  Database* database_;
  SessionId session_;
  std::string token_;  ///< nobody else's
};

}  // namespace study::storage
