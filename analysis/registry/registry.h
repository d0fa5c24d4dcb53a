#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "analysis/data/test_row.h"
#include "analysis/registry/test_data.h"

namespace analysis {

/// What an analyst chooses for a test.
struct TestSettings {
  double level = 0.95;                  ///< of confidence intervals, between 0 and 1
  std::optional<double> adjustedLevel;  ///< of the interval of one of several tests, if wanted
  std::optional<double> bound;  ///< of tests of equivalence: smaller differences count as none, > 0
  std::optional<int> from;      ///< of probabilities of answers: this one and all above it
};

/// Whether the results of a study have a test, and of what. A test that is used is computed for
/// every study and stands in its tables, exports and reports.
enum class StudyUse {
  None,
  Pairs,        ///< two conditions within people, by participants' means; one of a family of tests
  BesidePairs,  ///< the same beside the family: its p is not adjusted
  Conditions,   ///< all conditions within people, by participants' means
  Cohorts,      ///< participants' means of one condition in two cohorts
};

/// A statistical test that can be asked for by name, of any table.
struct StatisticalTest {
  enum class Form {
    OneRow,
    NeedsBound,      ///< one row, and TestSettings::bound
    RowOfEachPair,   ///< of groups or columns
    RowOfEachGroup,  ///< and TestSettings::from
  };

  std::string_view id;        ///< `palpate stats test ID`, and in tables
  std::string_view title;     ///< "Welch's t-test"
  std::string_view question;  ///< the question that it answers
  std::string_view source;    ///< author and year
  DataShape shape = DataShape::TwoGroups;
  std::vector<TestRow> (*rows)(const TestData&, const TestSettings&) = nullptr;
  StudyUse use = StudyUse::None;
  Form form = Form::OneRow;

  bool hasSeveralRows() const noexcept {
    return form == Form::RowOfEachPair || form == Form::RowOfEachGroup;
  }
};

/// Every test, by what it needs: two groups, several, pairs, columns, counts, models. A new test is
/// one line of this table (docs/developing.md).
std::span<const StatisticalTest> statisticalTests() noexcept;

/// @throws UserError  if there is no such test; names the nearest.
const StatisticalTest& statisticalTest(std::string_view id);

/// The rows of a test, with its id and the names of what is compared.
///
/// @throws UserError  for data that the test is not made for, and without the bound that it needs.
std::vector<TestRow> computeTest(
    const StatisticalTest& test, const TestData& data, const TestSettings& settings);

}  // namespace analysis
