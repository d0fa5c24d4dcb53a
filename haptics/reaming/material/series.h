#pragma once

#include <array>
#include <map>
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

/// Which columns a table has, where their heads do not say it: "time", "displacement", "force",
/// "torque" → the head in the file, and → its unit. Empty: found by the usual names.
struct SeriesMapping {
  std::map<std::string, std::string> heads;
  std::map<std::string, std::string> units;
};

/// Reads a table of a testing machine: a head and rows, separated by tabs, semicolons or commas,
/// decimals with a point or (where commas do not separate) a comma. Heads may name a unit in
/// brackets or after an underscore: "Weg [mm]", "force_n", "Kraft (kN)". Displacements in m, mm,
/// µm; forces in N, kN; torques in Nm, Nmm; times in s, ms. Lines above the head that begin with #
/// are remarks; one that begins with "# SYNTHETIC" marks data that were not measured.
///
/// @throws UserError  in one sentence: no such column, no unit, a cell that is not a
///     number, a gap in time, fewer than three rows, a displacement or a force beyond what can be.
Series readSeries(std::string_view text, const std::string& name, const SeriesMapping& mapping);

/// The same from a file; @p set is not in it. @throws UserError
Series readSeriesFile(const std::string& path, TestSet set, const SeriesMapping& mapping);

/// The bytes of a series' file. @throws UserError
std::string contentOfSeriesFile(const std::string& path);

/// A table that readSeries() reads: time_s, displacement_mm, force_n, torque_nm; above it a remark
/// where the series is synthetic.
std::string asText(const Series& series);

/// The reason why a series is not a valid measurement of reaming.
enum class ExclusionReason {
  None,
  Implausible,   ///< no numbers, too short, gaps, an axis that goes back
  FeedChanged,   ///< the reaming paper's (1): alterations of the feed rate during the test
  BrokeOut,      ///< (2): the acetabulum broke out of its resin embedding
  ReamedThrough  ///< (3): reamed completely after a displacement of 10 mm
};

struct Exclusion {
  ExclusionReason reason = ExclusionReason::None;
  std::string words;  ///< what happened, where, for people

  bool isExcluded() const noexcept { return reason != ExclusionReason::None; }
};

/// Looks for the paper's three reasons, and for data that cannot be a measurement at all.
///
/// - Feed: the slope of displacement over time, in twenty parts; one that differs from their median
///   by more than a third.
/// - Broke out: within half a second the force falls by more than half of what it had come to (20 N
///   or more), and never comes back to three quarters of it.
/// - Reamed through: beyond 10 mm the force stays below a tenth of its largest, to the end, for 1
/// mm
///   or more.
Exclusion exclusionOf(const Series& series);

}  // namespace haptics::reaming
