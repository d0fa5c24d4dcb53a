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
  Static,    ///< without reaming: pushed in at 0.07 mm/s until 800 N or 20 mm
  Dynamic1,  ///< reaming with the next larger size until the reamer stalls, or 20 mm
  Dynamic2,  ///< then reaming with a reamer that is 2 mm larger
};

inline constexpr std::array<std::string_view, 3> kTestSets{"static", "dynamic-1", "dynamic-2"};
constexpr std::string_view nameOf(TestSet set) noexcept {
  return kTestSets[static_cast<std::size_t>(set)];
}

/// The recording of a testing machine that pushes a reamer into an acetabulum: sampled evenly, all
/// columns of the same length.
struct Series {
  std::string name;  ///< name of the file, or specimen and test
  TestSet set = TestSet::Dynamic1;
  double rate = 100.0;               ///< of the samples [Hz]
  std::vector<double> displacement;  ///< along the axis, from the beginning of the test [m]
  std::vector<double> force;         ///< [N]
  std::vector<double> torque;        ///< [N·m]; empty if there is none
  bool isSynthetic = false;          ///< not measured

  double seconds() const noexcept { return static_cast<double>(force.size()) / rate; }
};

/// Says which columns of a table have other headings than the usual ones: maps "time",
/// "displacement", "force" and "torque" to the heading in the file, and to its unit. A quantity
/// that is not in a map is found by its usual heading.
struct SeriesMapping {
  std::map<std::string, std::string> heads;
  std::map<std::string, std::string> units;
};

/// Reads a table of a testing machine: a header line and rows, separated by tabs, semicolons or
/// commas, with decimal points or (if commas do not separate) decimal commas. A heading may end
/// with a unit in brackets or after an underscore: "Weg [mm]", "force_n", "Kraft (kN)".
/// Displacements in m, mm, µm; forces in N, kN; torques in Nm, Nmm; times in s, ms. Lines before
/// the header that begin with # are comments; "# SYNTHETIC" marks data that were not measured.
///
/// @throws UserError  if a column is missing, a unit is missing or unknown, a cell is not a number,
///     there is a gap in time, there are fewer than three rows, or a displacement or force is
///     larger than possible.
Series readSeries(std::string_view text, const std::string& name, const SeriesMapping& mapping);

/// Reads a table from a file, which does not contain @p set. @throws UserError
Series readSeriesFile(const std::string& path, TestSet set, const SeriesMapping& mapping);

/// The bytes of a series' file. @throws UserError
std::string contentOfSeriesFile(const std::string& path);

/// A table that readSeries() reads: time_s, displacement_mm, force_n, torque_nm; preceded by a
/// comment if the series is synthetic.
std::string asText(const Series& series);

/// The reason why a series is not a valid measurement of reaming.
enum class ExclusionReason {
  None,
  Implausible,   ///< not numeric, too short, with gaps, or an axis that moves back
  FeedChanged,   ///< the reaming paper's (1): alterations of the feed rate during the test
  BrokeOut,      ///< (2): the acetabulum broke out of its resin embedding
  ReamedThrough  ///< (3): reamed completely after a displacement of 10 mm
};

struct Exclusion {
  ExclusionReason reason = ExclusionReason::None;
  std::string words;  ///< a message: what happened, and where

  bool isExcluded() const noexcept { return reason != ExclusionReason::None; }
};

/// Checks a series for the paper's three reasons of exclusion, and for implausible data.
///
/// - Feed changed: in one of twenty parts of the test the feed differs from the median of the parts
///   by more than a third.
/// - Broke out: within a second the force (20 N or more) falls by half or more, and never regains
///   more than three quarters of its value before.
/// - Reamed through: beyond 10 mm, for 1 mm or more until the end, the force stays below a tenth of
///   its maximum.
Exclusion exclusionOf(const Series& series);

}  // namespace haptics::reaming
