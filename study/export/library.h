#pragma once

#include <span>
#include <string_view>

namespace study {

/// A file of study/library, as it was when the program was built: what goes into exports as it is.
struct LibraryFile {
  std::string_view name;  ///< "analysis.R"
  std::string_view content;
};

std::span<const LibraryFile> libraryFiles();

}  // namespace study
