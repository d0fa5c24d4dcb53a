#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/storage/erasure/erasure_repository.h"

namespace study::storage {

/// That a participant of a study was erased, as it is told outside of the study: in a list of the
/// station and in certificates. Every copy of the study has to be erased from, too.
struct ListedErasure {
  std::string study;  ///< uuid
  std::string participant;
  std::string enrolledUtc;  ///< tells the participant from another one with the same code
  ErasureLevel level = ErasureLevel::All;
  std::string utc;  ///< of the erasure

  bool operator==(const ListedErasure&) const = default;
};

/// One line; names nobody.
std::string asLine(const ListedErasure& erasure);
/// std::nullopt if the line is none of these.
std::optional<ListedErasure> listedErasureIn(const std::string& line);

/// What this station has listed of a study; nothing if it has no list. @throws StorageError
std::vector<ListedErasure> listedErasures(const std::string& study);

/// Adds an erasure to the list of this station, unless it stands there. @throws StorageError
void list(const ListedErasure& erasure);

/// The erasures of @p listed that were not done in the study of this database: those of
/// participants whom it has, from what it has not erased.
std::vector<ListedErasure> missingErasures(
    Database& database, const std::vector<ListedErasure>& listed);

}  // namespace study::storage
