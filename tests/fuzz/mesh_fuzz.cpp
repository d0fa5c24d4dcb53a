#include <cstddef>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "protocols/reading/mesh_file.h"
#include "questionnaires/json/problem.h"

// Fuzzes the reader of meshes: every index is of a vertex, and there are words for every refusal.

// Assimp 5.2.5 loses the mesh of a text STL that ends early.
// NOLINTNEXTLINE(bugprone-reserved-identifier, cert-dcl37-c, cert-dcl51-cpp): LeakSanitizer calls
// it
extern "C" const char* __lsan_default_suppressions() {
  return "leak:libassimp";
}

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t count) {
  const std::string_view text(reinterpret_cast<const char*>(data), count);
  try {
    for (const auto& surface : protocols::readMesh(text)) {
      for (const auto& triangle : surface.triangles) {
        for (const auto corner : triangle) {
          if (corner >= surface.places.size()) std::abort();
        }
      }
    }
  } catch (const base::UserError& error) {
    if (std::string_view(error.what()).empty()) std::abort();
  }
  return 0;
}
