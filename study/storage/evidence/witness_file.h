#pragma once

#include <string>
#include <vector>

#include "study/storage/evidence/station_heads.h"
#include "study/storage/evidence/trail_heads.h"

namespace study::storage {

/// Writes all signed heads of a trail, and one of its present end, to a new file. Kept out of reach
/// of those who can write the study, the file proves later what the study contained.
/// @throws StorageError  if the file exists or cannot be written, or this station has no key.
void writeWitness(const Database& study, const std::string& path, const std::string& utc);

/// The heads in such a file, with its name in place of a folder. Signatures are not checked.
/// @throws UserError  if it is no such file, or cannot be read.
std::vector<NotedHead> readWitness(const std::string& path);

/// Checks that the heads of a file are signed and of that study, and that the trail has the events
/// up to each.
Findings checkWitness(const TrailHeads& trail, const std::vector<NotedHead>& witness);

}  // namespace study::storage
