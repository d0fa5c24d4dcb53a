#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/storage/erasure/erasure_repository.h"

namespace study::storage {

/// An erasure as it is recorded outside of the study: in the station's list and in certificates. It
/// has to be repeated in every copy of the study.
struct ListedErasure {
  std::string study;  ///< uuid
  std::string participant;
  std::string enrolledUtc;  ///< distinguishes participants with the same code
  ErasureLevel level = ErasureLevel::All;
  std::string utc;  ///< of the erasure

  bool operator==(const ListedErasure&) const = default;
};

/// The erasure as one line of text, without names.
std::string asLine(const ListedErasure& erasure);
/// Parses a line of asLine(); std::nullopt for other text.
std::optional<ListedErasure> listedErasureIn(const std::string& line);

/// The erasures of a study in this station's list; empty if there is no list. @throws StorageError
std::vector<ListedErasure> listedErasures(const std::string& study);

/// Adds an erasure to the list of this station, unless it is listed already. @throws StorageError
void list(const ListedErasure& erasure);

/// The erasures of @p listed that have to be repeated in this database: it has the participant, and
/// has not erased what @p listed says.
std::vector<ListedErasure> erasuresToRepeat(
    Database& database, const std::vector<ListedErasure>& listed);

}  // namespace study::storage
