#include "study/storage/transaction.h"

namespace study::storage {

Transaction::Transaction(Database& database) : database_(database) {
  database_.rollBackIfOwed();
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!isOpen_) return;
  try {
    database_.owesRollback();
    database_.rollBackIfOwed();
  } catch (const StorageError&) {
    // Still marked: the next transaction rolls it back before it begins.
  }
}

void Transaction::commit() {
  // If COMMIT throws, the transaction stays open here and the destructor rolls it back, unless
  // SQLite has ended it already (see Database::rollBackIfOwed()).
  database_.execute("COMMIT");
  isOpen_ = false;
}

}  // namespace study::storage
