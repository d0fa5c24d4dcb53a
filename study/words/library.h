#pragma once

#include <span>
#include <string_view>

namespace study::words {

/// A catalogue of study/words/library, compiled into the program.
struct LibraryFile {
  std::string_view name;  ///< "de.json"
  std::string_view content;
};

std::span<const LibraryFile> libraryFiles();

}  // namespace study::words
