#pragma once

#include <string_view>

namespace base {

/// A file of the sources that is compiled into the program, so that a study needs no installed
/// files. CMake's embed_files() makes the function that lists them.
struct EmbeddedFile {
  std::string_view name;  ///< "punch-face-validity.json"
  std::string_view content;
};

}  // namespace base
