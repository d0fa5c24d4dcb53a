#include "tests/support/test_data.h"

namespace tests {

std::filesystem::path repository() {
  return PALPATE_SOURCE_DIR;
}

std::filesystem::path testData(std::string_view relative) {
  return repository() / "tests/data" / relative;
}

std::filesystem::path fetchedData(std::string_view relative) {
  return std::filesystem::path(PALPATE_FETCHED_DATA) / relative;
}

}  // namespace tests
