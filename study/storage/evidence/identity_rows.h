#pragma once

#include <string>
#include <vector>

#include "study/storage/database.h"
#include "study/storage/identity_store.h"

namespace study::storage {

/// A row of identity.db that names a person, with its stored bytes.
struct IdentityRow {
  std::string name;        ///< participant, session, step, attempt, item: "P001/1/3/1/signature"
  std::string bytes = {};  ///< all columns of the row, sealed or not
};

std::vector<IdentityRow> identityRows(const Database& identities);

/// The sealed rows whose text can be unsealed, each with the bytes that it had before its text was
/// sealed.
/// @throws StorageError  if names are locked.
std::vector<IdentityRow> identityRowsBeforeSealing(IdentityStore& identities);

}  // namespace study::storage
