#pragma once

#include <cstdint>
#include <filesystem>

namespace study::bench {

/// A synthetic study, made for a measurement.
struct SyntheticStudy {
  std::filesystem::path folder;
  std::int64_t sessions = 0;
};

/// A study of the published protocol with @p answers made-up answers of simulated participants, in
/// the folder @p inside, which exists. Its audit trail says only that a program made it: `study
/// verify` would not call it sound. Written as fast as the database allows; the same numbers each
/// time.
/// @throws storage::StorageError
SyntheticStudy makeSyntheticStudy(const std::filesystem::path& inside, std::int64_t answers);

}  // namespace study::bench
