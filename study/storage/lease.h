#pragma once

#include <string>

#include "study/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// The right to run a session: one program at a time. Given back when this object goes; what a
/// crashed program of this computer left behind is taken over.
class Lease {
 public:
  /// @throws StorageError  (Busy) if another program is running this session; says which.
  Lease(Database& database, SessionId session, const std::string& utc);
  ~Lease();
  Lease(Lease&& other) noexcept;
  Lease& operator=(Lease&&) = delete;

 private:
  Database* database_;
  SessionId session_;
};

}  // namespace study::storage
