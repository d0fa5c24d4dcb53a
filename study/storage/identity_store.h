#pragma once

#include <string>

#include "study/ids.h"
#include "study/storage/database.h"

namespace study::storage {

/// identity.db: answers that name a person. Apart from everything else, never exported.
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

  Database& database() noexcept { return database_; }

 private:
  Database database_;
};

}  // namespace study::storage
