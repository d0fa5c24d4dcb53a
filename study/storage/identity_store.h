#pragma once

#include <string>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// identity.db: answers that name a person. Apart from everything else, never exported. Each row
/// carries a hash of itself, since the audit trail may not vouch for what it must not know.
class IdentityStore {
 public:
  explicit IdentityStore(Database database) : database_(std::move(database)) {}

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
  bool has(const Place& place, const std::string& item) const;

  /// The rows that are not what was written, by participant and item. (Format 1 kept no hash.)
  std::vector<std::string> damaged() const;

  Database& database() noexcept { return database_; }

 private:
  Database database_;
};

}  // namespace study::storage
