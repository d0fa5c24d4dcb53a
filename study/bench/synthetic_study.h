#pragma once

#include <cstdint>
#include <filesystem>

namespace study::bench {

/// A synthetic study for a measurement.
struct SyntheticStudy {
  std::filesystem::path folder;
  std::int64_t sessions = 0;
};

/// Creates a study with the published protocol and @p answers random answers of simulated
/// participants, in the existing folder @p parentFolder. Its audit trail has no events of the
/// sessions, so `study verify` would report problems. The study is written as fast as the database
/// allows; its answers are the same each time.
/// @throws storage::StorageError  if the study cannot be written.
SyntheticStudy makeSyntheticStudy(const std::filesystem::path& parentFolder, std::int64_t answers);

}  // namespace study::bench
