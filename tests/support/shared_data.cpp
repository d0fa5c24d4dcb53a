#include "tests/support/shared_data.h"

namespace tests {

std::filesystem::path sharedData(std::string_view relative) {
  return std::filesystem::path(PALPATE_SHARED_DATA) / relative;
}

}  // namespace tests
