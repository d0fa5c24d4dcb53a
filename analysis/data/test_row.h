#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/reason.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// A number and its name in a table: "t", "chi2", "g_z".
struct NamedNumber {
  std::string_view name;  ///< snake_case; empty if the test has no such number
  std::optional<double> value;
};

/// Mean and variance of one group.
struct GroupMoments {
  std::optional<double> mean;
  std::optional<double> variance;  ///< divided by n − 1
};

/// The result of any statistical test, as one row of a table. Text, JSON, CSV and reports are made
/// from it. If a number is missing, `reason` says why.
struct TestRow {
  std::string_view id;  ///< of the test: "welch", as in tables and on the command line

  std::string group1;  ///< the compared groups; differences are group 1 − group 2
  std::string group2;
  /// Size of group 1; the number of pairs, persons or cases if the test has a single n.
  std::optional<std::uint64_t> n1;
  std::optional<std::uint64_t> n2;
  /// Set by tests that compare means of groups.
  std::optional<std::array<GroupMoments, 2>> moments;

  NamedNumber estimate;
  std::optional<double> standardError;
  std::optional<Interval> interval;  ///< of the estimate
  /// Simultaneous confidence interval of the estimate: its level is corrected for the m tests of
  /// the family.
  std::optional<Interval> adjustedInterval;

  NamedNumber statistic;     ///< may be infinite
  std::optional<double> df;  ///< degrees of freedom; for F, of the numerator
  std::optional<double> df2;

  std::optional<double> p;            ///< two-sided unless docs/statistics.md says otherwise
  std::optional<double> log10P;       ///< defined even if p is too small for a double
  bool isInFamily = false;            ///< p is adjusted for the number of tests in a family
  std::optional<double> adjusted;     ///< p after the adjustment
  std::optional<bool> isSignificant;  ///< adjusted ≤ alpha

  NamedNumber effect;
  std::optional<Interval> effectInterval;
  Reason effectReason;  ///< why the effect is missing, if `reason` does not say it

  std::vector<NamedNumber> more;  ///< numbers specific to this test: "p_exact", "epsilon"
  Reason reason;                  ///< why something above is missing; empty if nothing is

  /// The number @p name of `more`; std::nullopt if the test has no such number, or it is not
  /// defined.
  std::optional<double> additionalNumber(std::string_view name) const {
    for (const auto& number : more) {
      if (number.name == name) return number.value;
    }
    return std::nullopt;
  }
};

/// The row of the test @p id; nullptr if @p rows has none.
const TestRow* findTest(std::span<const TestRow> rows, std::string_view id);

/// @throws std::out_of_range  if @p rows has no such test.
const TestRow& testNamed(std::span<const TestRow> rows, std::string_view id);

}  // namespace analysis
