#pragma once

#include <string>
#include <vector>

#include "study/storage/database.h"

namespace study::storage {

/// A row of identity.db that names a person, byte for byte as it is stored.
struct IdentityRow {
  std::string name;        ///< "P001/1/3/1/signature": participant, session, step, attempt, item
  std::string bytes = {};  ///< all that the row stores, sealed or not
};

std::vector<IdentityRow> identityRows(const Database& identities);

}  // namespace study::storage
