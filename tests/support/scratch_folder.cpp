#include "tests/support/scratch_folder.h"

#include <cstdlib>
#include <fstream>
#include <iterator>
#include <stdexcept>
#include <system_error>

#include "base/file.h"

namespace tests {

ScratchFolder::ScratchFolder() {
  // Pictures show the paths of studies: "~/studies/punch", if make has set HOME and TMPDIR.
  const auto plain = std::filesystem::temp_directory_path() / "studies";
  std::error_code ignored;
  if (std::getenv("PALPATE_PICTURES") != nullptr &&
      std::filesystem::create_directory(plain, ignored)) {
    path_ = plain;
    return;
  }
  std::string pattern = (std::filesystem::temp_directory_path() / "palpate-test-XXXXXX").string();
  if (mkdtemp(pattern.data()) == nullptr) throw std::runtime_error("no scratch folder");
  path_ = pattern;
}

ScratchFolder::~ScratchFolder() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

std::string ScratchFolder::write(std::string_view name, std::string_view content) const {
  const auto file = path_ / name;
  std::filesystem::create_directories(file.parent_path());
  std::ofstream(file, std::ios::binary) << content;
  return file.string();
}

std::string contentOf(const std::filesystem::path& file) {
  std::ifstream stream(file, std::ios::binary);
  if (!stream) throw std::runtime_error("cannot read " + file.string());
  return base::readAll(stream);
}

}  // namespace tests
