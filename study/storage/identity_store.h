#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/model/ids.h"
#include "study/storage/blinding_secret.h"
#include "study/storage/database.h"

namespace study::storage {

/// identity.db: answers that name a person, and the secret of the study. They are stored apart from
/// everything else and never exported. Each row carries a hash of itself, because the audit trail
/// must not contain anything about them.
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

  /// All answers that name people.
  std::vector<std::string> texts() const;

  /// One transaction. @throws StorageError  if there is one already.
  void put(const BlindingSecret& secret);
  /// std::nullopt in studies that an older release made.
  std::optional<BlindingSecret> blindingSecret() const;

  /// The rows that differ from what was written, by participant and item. (Format 1 stored no
  /// hash.)
  std::vector<std::string> damaged() const;

  Database& database() noexcept { return database_; }

 private:
  Database database_;
};

}  // namespace study::storage
