#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/factor.h"

namespace analysis {

/// The layout of a table that a test is computed from.
enum class DataShape {
  TwoGroups,    ///< a column with the names of two groups, and a column of numbers
  Groups,       ///< like TwoGroups, with two groups or more
  Pairs,        ///< two columns of numbers, one pair per line
  Columns,      ///< one line per participant, one column of numbers per condition, item or rater
  Values,       ///< one column of numbers
  Categories,   ///< two columns of names, one case per line
  BeforeAfter,  ///< like Categories, with the same names in both columns
  Votes,        ///< one column of names, one vote per line
  Clusters,     ///< a column of numbers, the group and the cluster (participant) of each
};

/// One column that a shape needs.
struct DataColumn {
  enum class Kind { Number, Name, Count, Numbers };

  std::string_view role;  ///< "group": the option --group names the column
  Kind kind = Kind::Number;
  /// Without the option: true: the file's next column is used; false: the column of this name.
  bool isRequired = true;
  std::string_view what;  ///< description in messages
};

/// The columns of a shape, in their default order in a file.
std::span<const DataColumn> columnsOf(DataShape shape) noexcept;

/// The names of the chosen columns of the file, by role; a role of kind Numbers may have several.
using ChosenColumns = std::map<std::string, std::vector<std::string>>;

/// The numbers of one group or column, in the order of the file.
struct NamedValues {
  std::string name;
  std::vector<double> values;
};

/// The names in one column, one per case.
struct NameColumn {
  std::string role;
  std::vector<std::string> values;
};

/// The data that were read for a test.
struct TestData {
  std::vector<NamedValues> values;    ///< one entry per group; or one per column, of equal length
  std::vector<NameColumn> names;      ///< one entry per column
  std::vector<std::uint64_t> counts;  ///< how often each case occurred
  std::size_t missing = 0;            ///< lines left out because a cell is empty or NA

  /// The values by line: [line][column].
  std::vector<std::vector<double>> lines() const;
  /// The names of a role as a factor; without levels if the role has no column.
  Factor factor(std::string_view role) const;
};

/// How often the levels of two columns of names occurred together.
struct ContingencyTable {
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  std::vector<std::vector<std::uint64_t>> counts;  ///< [row][column]
};

/// Counts how often each name of the first column occurs with each name of the second, by the
/// numbers of cases (TestData::counts).
/// @param isSquare  rows and columns both list the names of both columns, in the order of their
///     appearance.
ContingencyTable contingencyTableOf(const TestData& data, bool isSquare);

/// Reads a table of comma-separated values (see readCsv()) for a test. If semicolons separate the
/// cells, decimal commas are accepted.
///
/// Where options name all columns that the shape needs, no others are used. Otherwise the columns
/// that no option names are used from left to right, and none may be left over.
///
/// @throws UserError  with a message for the operator: a column is missing or the shape does not
///     use it, a column is left over, there are no rows, a cell is no number, or there are too few
///     or too many groups.
TestData readTestData(std::string_view csv, DataShape shape, const ChosenColumns& chosen);

}  // namespace analysis
