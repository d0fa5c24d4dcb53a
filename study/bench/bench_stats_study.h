#pragma once

#include <cstdint>
#include <filesystem>

namespace study::app {

/// A synthetic study, made for a measurement.
struct SyntheticStudy {
  std::filesystem::path folder;
  std::filesystem::path answers;  ///< the same as a CSV file, for peers; empty where nobody asked
  std::filesystem::path keys;     ///< … and the keys of its items
  std::int64_t sessions = 0;
};

/// A study of the published protocol with @p answers made-up answers of simulated people, in a
/// folder @p inside that is there. Its audit trail says that it was made by a machine, and nothing
/// else: `study verify` would not call it sound. Written as fast as rows can be; the same numbers
/// each time.
/// @throws storage::StorageError
SyntheticStudy makeSyntheticStudy(
    const std::filesystem::path& inside, std::int64_t answers, bool withCsv);

}  // namespace study::app
