#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/data/test_row.h"
#include "analysis/registry/test_data.h"

namespace analysis {

/// The options of a test.
struct TestSettings {
  double level = 0.95;  ///< of confidence intervals, between 0 and 1
  /// Level of an additional confidence interval, adjusted for several tests; std::nullopt: no such
  /// interval.
  std::optional<double> adjustedLevel;
  /// Equivalence margin > 0: differences within ± bound do not matter.
  std::optional<double> bound;
  /// For tests of high answers: the lowest answer that counts as high.
  std::optional<int> from;
};

/// Whether the results of a study include a test, and what it compares. A test that is used is
/// computed for every study and appears in its tables, exports and reports.
enum class StudyUse {
  None,
  Pairs,  ///< two conditions within participants, by participants' means; p is adjusted within the
          ///< family
  PairsOutsideFamily,  ///< like Pairs, but outside the family: p is not adjusted
  Conditions,          ///< all conditions within participants, by participants' means
  Cohorts,             ///< participants' means of one condition in two cohorts
};

/// A statistical test that is selected by name and computed from a table of data.
struct StatisticalTest {
  /// The rows that the test returns, and the setting that it needs.
  enum class Form {
    OneRow,
    NeedsBound,      ///< one row, and TestSettings::bound
    RowOfEachPair,   ///< one row for each pair of groups or columns
    RowOfEachGroup,  ///< one row for each group; needs TestSettings::from
  };

  std::string_view id;        ///< as in `palpate stats test ID` and in tables
  std::string_view title;     ///< "Welch's t-test"
  std::string_view question;  ///< the question that the test answers
  std::string_view source;    ///< author and year
  DataShape shape = DataShape::TwoGroups;
  std::vector<TestRow> (*rows)(const TestData&, const TestSettings&) = nullptr;
  StudyUse use = StudyUse::None;
  Form form = Form::OneRow;
  /// The fewest people, of each group that is compared, with whom a report shows the test: with
  /// fewer, its approximation is too rough to be put beside exact tests.
  std::size_t fewestPeople = 0;

  bool hasSeveralRows() const noexcept {
    return form == Form::RowOfEachPair || form == Form::RowOfEachGroup;
  }
};

/// All tests, ordered by their data: two groups, several groups, pairs, columns, counts, models. To
/// add a test, add one line to this table (docs/developing.md).
std::span<const StatisticalTest> statisticalTests() noexcept;

/// @throws UserError  if there is no such test; the message names the most similar one.
const StatisticalTest& statisticalTest(std::string_view id);

/// Computes a test. The rows have its id and the names of the compared groups.
///
/// @throws UserError  for data that do not fit the test, and if `bound` or `from` is missing but
///     needed by the test, or set but not used by it.
std::vector<TestRow> computeTest(
    const StatisticalTest& test, const TestData& data, const TestSettings& settings);

}  // namespace analysis
