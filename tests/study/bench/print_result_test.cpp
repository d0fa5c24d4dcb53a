#include "study/bench/print_result.h"

#include <gtest/gtest.h>

namespace study::bench {
namespace print_result_test {

TEST(PlainText, AlignsColumnsByTheirCharacters) {
  const DataTable table{
      .name = "times",
      .description = "Times",
      .columns = {{"method", "Method"}, {"time_ns", "Time [ns]"}, {"passed", "Passed"}},
      .rows = {{"LDLᵀ", 1234567.0, true}, {"dense LU", {}, false}}};
  EXPECT_EQ(
      asPlainText(table),
      "  Method    Time [ns]  Passed\n"
      "  LDLᵀ      1.235e+06  yes\n"
      "  dense LU  –          no\n");
}

}  // namespace print_result_test
}  // namespace study::bench
