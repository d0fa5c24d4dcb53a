#pragma once

#include <string>
#include <vector>

#include "study/storage/evidence/station_heads.h"
#include "study/storage/evidence/trail_heads.h"

namespace study::storage {

/// Writes all heads that were signed in a trail, and one of now, to a new file. Kept where those
/// who can write the study cannot, it proves later what the study was.
/// @throws StorageError  if the file exists or cannot be written, or this station has no key.
void writeWitness(const Database& study, const std::string& path, const std::string& utc);

/// The heads in such a file, with its name in place of a folder. Signatures are not checked.
/// @throws UserError  if it is no such file, or cannot be read.
std::vector<NotedHead> readWitness(const std::string& path);

/// Whether a trail goes on from the heads in a file, and whether they are signed and of that study.
Findings checkWitness(const TrailHeads& trail, const std::vector<NotedHead>& witness);

}  // namespace study::storage
