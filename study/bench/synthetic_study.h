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
/// in the existing folder @p inside. Its audit trail has one event of a program only, so `study
/// verify` would report problems. Written as fast as the database allows, with the same numbers
/// each time.
/// @throws storage::StorageError
SyntheticStudy makeSyntheticStudy(const std::filesystem::path& inside, std::int64_t answers);

}  // namespace study::bench
