#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace analysis {

/// The values of one group, in the order of the file.
struct NamedValues {
  std::string name;
  std::vector<double> values;
};

/// Two groups from an analyst's own table.
struct GroupedValues {
  NamedValues group1;  ///< the one that the file names first
  NamedValues group2;
  std::size_t missing = 0;  ///< rows left out because group or value is empty or NA
};

/// Reads two groups from a table of comma-separated values that has a column of group names and a
/// column of numbers; other columns do not matter. With semicolons between the cells, a decimal
/// comma is understood.
///
/// @throws Error  in words for the person at the desk: a table that cannot be read (see readCsv()),
///     a column that is not there, no rows, values that are no numbers, or groups other than two.
GroupedValues readGroupedValues(
    std::string_view csv, std::string_view groupColumn, std::string_view valueColumn);

}  // namespace analysis
