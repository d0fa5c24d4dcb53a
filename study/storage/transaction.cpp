#include "study/storage/transaction.h"

namespace study::storage {

Transaction::Transaction(Database& database) : database_(database) {
  database_.undoWhatIsLeft();
  database_.execute("BEGIN IMMEDIATE");
}

Transaction::~Transaction() {
  if (!isOpen_) return;
  try {
    database_.owesRollback();
    database_.undoWhatIsLeft();
  } catch (const StorageError&) {
    // The next transaction undoes it before it begins.
  }
}

void Transaction::commit() {
  database_.execute("COMMIT");
  isOpen_ = false;
}

}  // namespace study::storage
