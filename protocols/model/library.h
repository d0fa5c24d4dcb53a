#pragma once

#include <span>
#include <string_view>

namespace protocols {

/// A file of protocols/library, compiled into the program.
struct LibraryFile {
  std::string_view name;  ///< "punch-face-validity.json"
  std::string_view content;
};

std::span<const LibraryFile> libraryFiles();

}  // namespace protocols
