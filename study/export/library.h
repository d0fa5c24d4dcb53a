#pragma once

#include <span>
#include <string_view>

namespace study {

/// A file of study/library, compiled into the program and exported unchanged.
struct LibraryFile {
  std::string_view name;  ///< "analysis.R"
  std::string_view content;
};

std::span<const LibraryFile> libraryFiles();

}  // namespace study
