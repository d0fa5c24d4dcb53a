#pragma once

#include "study/storage/database.h"

namespace study::storage {

/// What belongs together: all of it, or nothing. Begins by taking the right to write, so that it
/// cannot find out halfway that somebody else has it.
class Transaction {
 public:
  /// @throws StorageError  (Busy) if another program keeps the right to write for too long.
  explicit Transaction(Database& database);
  /// Undoes what was not committed.
  ~Transaction();
  Transaction(const Transaction&) = delete;
  Transaction& operator=(const Transaction&) = delete;

  /// On return everything is on the disk. @throws StorageError  and then it is *unknown*, not
  /// undone: whoever catches it reads back before saying anything.
  void commit();

 private:
  Database& database_;
  bool isOpen_ = true;
};

}  // namespace study::storage
