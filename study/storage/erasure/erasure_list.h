#pragma once

#include <optional>
#include <string>
#include <vector>

#include "study/storage/erasure/erasure_repository.h"

namespace study::storage {

/// The record of an erasure outside of the study: in the station's list and in certificates. The
/// erasure must be repeated in every copy of the study.
struct ListedErasure {
  std::string study;  ///< uuid
  std::string participant;
  std::string enrolledUtc;  ///< distinguishes participants who had the same code
  ErasureLevel level = ErasureLevel::All;
  std::string utc;  ///< of the erasure

  bool operator==(const ListedErasure&) const = default;
};

/// The erasure as one line of text, without names.
std::string asLine(const ListedErasure& erasure);
/// Parses a line of asLine(), also with other blanks between its fields; std::nullopt for other
/// text.
std::optional<ListedErasure> listedErasureIn(const std::string& line);

/// The erasures of a study in this station's list; empty if there is no list. @throws StorageError
std::vector<ListedErasure> listedErasures(const std::string& study);

/// Adds an erasure to this station's list, unless the list has it already. @throws StorageError
void addListedErasure(const ListedErasure& erasure);

/// Those of the erasures in @p listed that must be repeated in this database: it has the
/// participant, and the data of that level are not erased in it.
std::vector<ListedErasure> erasuresToRepeat(
    Database& database, const std::vector<ListedErasure>& listed);

}  // namespace study::storage
