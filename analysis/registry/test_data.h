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

/// What a test is computed from, as a table holds it.
enum class DataShape {
  TwoGroups,    ///< a column of group names, two of them, and a column of numbers
  Groups,       ///< the same with two groups or more
  Pairs,        ///< two columns of numbers, a pair a line
  Columns,      ///< a line a participant, a column of numbers a condition, item or rater
  Values,       ///< one column of numbers
  Categories,   ///< two columns of names, a case a line
  BeforeAfter,  ///< the same with the same names in both
  Votes,        ///< one column of names, a vote a line
  Clusters,     ///< a column of numbers, the group and the cluster (participant) of each
};

/// One column that a shape needs.
struct DataColumn {
  enum class Kind { Number, Name, Count, Numbers };

  std::string_view role;  ///< "group": the option --group names the column
  Kind kind = Kind::Number;
  bool isRequired = true;  ///< without its option, the file's first, second, … column
  std::string_view what;   ///< for people
};

/// The columns of a shape in the order in which a file has them if nothing else is said.
std::span<const DataColumn> columnsOf(DataShape shape) noexcept;

/// Which column of the file has which role; Numbers may have several.
using ChosenColumns = std::map<std::string, std::vector<std::string>>;

/// The numbers of one group or column, in the order of the file.
struct NamedValues {
  std::string name;
  std::vector<double> values;
};

/// The names in one column, one a case.
struct Names {
  std::string role;
  std::vector<std::string> values;
};

/// What has been read for a test.
struct TestData {
  std::vector<NamedValues> values;    ///< by group; or column by column, of equal length
  std::vector<Names> names;           ///< column by column
  std::vector<std::uint64_t> counts;  ///< how often each case occurred
  std::size_t missing = 0;            ///< lines left out because a cell is empty or NA

  /// The values by line: [line][column].
  std::vector<std::vector<double>> lines() const;
  /// The names of a role as a factor; no levels where the role has no column.
  Factor factor(std::string_view role) const;
};

/// How often the levels of two columns of names occurred together.
struct CrossTable {
  std::vector<std::string> rows;
  std::vector<std::string> columns;
  std::vector<std::vector<std::uint64_t>> counts;  ///< [row][column]
};

/// @param isSquare  rows and columns are the names of both, in the order of their appearance.
CrossTable crossTableOf(const TestData& data, bool isSquare);

/// Reads a table of comma-separated values (see readCsv()) for a test. With semicolons between the
/// cells, a decimal comma is understood.
///
/// @throws UserError  in words for the person at the desk: a column that is not there or that the
/// shape
///     does not use, no rows, cells that are not numbers, too few or too many groups.
TestData readTestData(std::string_view csv, DataShape shape, const ChosenColumns& chosen);

}  // namespace analysis
