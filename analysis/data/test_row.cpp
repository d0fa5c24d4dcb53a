#include "analysis/data/test_row.h"

#include <stdexcept>

#include "base/search.h"

namespace analysis {

const TestRow* findTest(std::span<const TestRow> rows, std::string_view id) {
  return base::withId(rows, id);
}

const TestRow& testNamed(std::span<const TestRow> rows, std::string_view id) {
  const auto* row = findTest(rows, id);
  if (row == nullptr) throw std::out_of_range("there is no row of the test " + std::string(id));
  return *row;
}

}  // namespace analysis
