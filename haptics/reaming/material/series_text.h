#pragma once

#include <map>
#include <string>
#include <string_view>

#include "haptics/reaming/material/series.h"

namespace haptics::reaming {

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
/// @throws recordings::Error  in one sentence: no such column, no unit, a cell that is not a
///     number, a gap in time, fewer than three rows, a displacement or a force beyond what can be.
Series readSeries(std::string_view text, const std::string& name, const SeriesMapping& mapping);

/// The same from a file; @p set is not in it. @throws recordings::Error
Series readSeriesFile(const std::string& path, TestSet set, const SeriesMapping& mapping);

/// The bytes of a series' file. @throws recordings::Error
std::string contentOfSeriesFile(const std::string& path);

/// A table that readSeries() reads: time_s, displacement_mm, force_n, torque_nm; above it a remark
/// where the series is synthetic.
std::string asText(const Series& series);

}  // namespace haptics::reaming
