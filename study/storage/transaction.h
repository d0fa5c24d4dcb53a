#pragma once

#include "study/storage/database.h"

namespace study::storage {

/// A transaction: all of its changes are written, or none. It takes the write lock at once, so that
/// it cannot fail halfway because another program holds it.
class Transaction {
 public:
  /// @throws StorageError  (Busy) if another program holds the write lock for too long.
  explicit Transaction(Database& database);
  /// Rolls back what was not committed.
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// On return everything is on the disk.
  /// @throws StorageError  and then the outcome is *unknown*: the caller reads the data back before
  ///     reporting anything.
  void commit();

 private:
  Database& database_;
  bool isOpen_ = true;
};

}  // namespace study::storage
