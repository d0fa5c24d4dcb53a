#pragma once

#include <cstdint>
#include <filesystem>

namespace study::bench {

/// A synthetic study for a measurement.
struct SyntheticStudy {
  std::filesystem::path folder;
  std::int64_t sessions = 0;
};

/// A study of the published protocol with @p answers artificial answers of simulated participants,
/// in the existing folder @p inside. Its audit trail has a single event, so `study verify` would
/// report problems. Written as fast as the database allows; the content is the same each time.
/// @throws storage::StorageError  if the study cannot be written.
SyntheticStudy makeSyntheticStudy(const std::filesystem::path& inside, std::int64_t answers);

}  // namespace study::bench
