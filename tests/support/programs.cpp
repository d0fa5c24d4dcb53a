#include "tests/support/programs.h"

#include <cstdlib>
#include <filesystem>

namespace tests {
namespace {

std::string chosen(const char* variable, const char* built) {
  const char* other = std::getenv(variable);
  return other != nullptr ? other : built;
}

}  // namespace

std::string program() {
  return chosen("PALPATE_PROGRAM", PROGRAM_OF_THIS_BUILD);
}

std::string studio() {
  return chosen("PALPATE_STUDIO_PROGRAM", STUDIO_OF_THIS_BUILD);
}

std::string punchFirmware() {
  return PUNCH_FIRMWARE;
}

std::string thisProgram() {
  return std::filesystem::read_symlink("/proc/self/exe").string();
}

}  // namespace tests
