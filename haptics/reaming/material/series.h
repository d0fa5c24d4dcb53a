#pragma once

#include <array>
#include <string>
#include <string_view>
#include <vector>

namespace haptics::reaming {

/// Which of the three tests of a specimen a series comes from (reaming paper, "Experimental
/// setup").
enum class TestSet {
  Static,    ///< the reamer is off: pushed in at 0.07 mm/s until 800 N or 20 mm
  Dynamic1,  ///< reaming with the next larger size until it stalls, or 20 mm
  Dynamic2,  ///< and with one 2 mm larger
};

inline constexpr std::array<std::string_view, 3> kTestSets{"static", "dynamic-1", "dynamic-2"};
constexpr std::string_view nameOf(TestSet set) noexcept {
  return kTestSets[static_cast<std::size_t>(set)];
}

/// What a testing machine wrote while it pushed a reamer into an acetabulum: sampled evenly, all
/// columns of one length. No torque where none was measured.
struct Series {
  std::string name;  ///< of its file, or a specimen and a test
  TestSet set = TestSet::Dynamic1;
  double rate = 100.0;               ///< of the samples [Hz]
  std::vector<double> displacement;  ///< along the axis, from where the test began [m]
  std::vector<double> force;         ///< [N]
  std::vector<double> torque;        ///< [N·m]; empty if there is none
  bool isSynthetic = false;          ///< not measured

  double seconds() const noexcept { return static_cast<double>(force.size()) / rate; }
};

}  // namespace haptics::reaming
