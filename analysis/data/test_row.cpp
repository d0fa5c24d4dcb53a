#include "analysis/data/test_row.h"

#include <algorithm>
#include <stdexcept>

namespace analysis {

const TestRow* findTest(std::span<const TestRow> rows, std::string_view id) {
  const auto found = std::ranges::find(rows, id, &TestRow::id);
  return found == rows.end() ? nullptr : &*found;
}

const TestRow& testNamed(std::span<const TestRow> rows, std::string_view id) {
  const auto* row = findTest(rows, id);
  if (row == nullptr) throw std::out_of_range("there is no row of the test " + std::string(id));
  return *row;
}

}  // namespace analysis
