#pragma once

#include <span>

#include "base/embedded_file.h"
#include "study/collect/server/connection.h"

namespace study::collect {

/// The steps of the schema in order. Step n brings a server from version n - 1 to n.
std::span<const base::EmbeddedFile> schemaSteps();

/// The version that this program installs and needs.
int newestSchema();

/// The version that is installed; 0: none. @throws ServerError
int installedSchema(Connection& server);

/// Makes the roles and the schema 'palpate', or updates an older schema, in one transaction. Does
/// nothing if the schema is up to date.
/// @throws ServerError  Denied, if the role may not create roles and schemas; Other, if the server
///     has a newer schema than this program.
/// @return  the version that was there before
int installSchema(Connection& server);

/// @throws ServerError  if the schema is missing, or of another version than this program's.
void requireSchema(Connection& server);

}  // namespace study::collect
