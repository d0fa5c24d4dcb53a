#include "tests/support/programs.h"

#include <cstdlib>
#include <filesystem>

namespace tests {

std::string program() {
  return PROGRAM_OF_THIS_BUILD;
}

std::string releaseProgram() {
  const char* release = std::getenv("PALPATE_RELEASE_PROGRAM");  // NOLINT: one thread
  return release != nullptr ? release : program();
}

std::string studio() {
  return STUDIO_OF_THIS_BUILD;
}

std::string releaseStudio() {
  const auto beside = std::filesystem::path(releaseProgram()).parent_path() / "palpate-studio";
  return std::filesystem::exists(beside) ? beside.string() : studio();
}

std::string punchFirmware() {
  return PUNCH_FIRMWARE;
}

std::string thisProgram() {
  return std::filesystem::read_symlink("/proc/self/exe").string();
}

}  // namespace tests
