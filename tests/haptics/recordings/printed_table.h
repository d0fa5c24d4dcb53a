#pragma once

#include <array>
#include <cstddef>

namespace tests {

/// Which of the 76 rows (from 0) has which travel and force in the authors' sketch, to the three
/// decimals printed.
struct PrintedPair {
  std::size_t index;
  double travel;  ///< [travel units]
  double force;   ///< [N]
};

inline constexpr std::array kPrintedTable{
    PrintedPair{0, 2.079, 0.000},
    PrintedPair{16, 3.813, 0.000},
    PrintedPair{17, 3.961, 0.084},
    PrintedPair{19, 4.283, 0.823},
    PrintedPair{24, 5.171, 3.313},
    PrintedPair{30, 6.335, 4.344},
    PrintedPair{34, 7.183, 4.369},
    PrintedPair{44, 9.429, 3.966},
    PrintedPair{51, 10.349, 3.679},
    PrintedPair{75, 10.820, 4.344}};

inline constexpr double kPrintedRounding = 5e-4;

}  // namespace tests
