#pragma once

#include <string>
#include <vector>

#include "study/storage/evidence/station_heads.h"
#include "study/storage/evidence/trail_heads.h"

namespace study::storage {

/// Writes all signed heads of a trail, and a signed head of its present end, to a new file. If
/// people who can write the study cannot change this file, it proves later what the study
/// contained.
/// @throws StorageError  if the file exists or cannot be written, or this station has no key.
void writeWitness(const Database& study, const std::string& path, const std::string& utc);

/// The heads in a witness file; RecordedHead::folder is the name of the file. Signatures are not
/// checked.
/// @throws UserError  if the file is no witness file, or cannot be read.
std::vector<RecordedHead> readWitness(const std::string& path);

/// Checks that the heads of a witness file are signed and belong to this study, and that the trail
/// contains the events up to each of them.
Findings checkWitness(const TrailHeads& trail, const std::vector<RecordedHead>& witness);

}  // namespace study::storage
