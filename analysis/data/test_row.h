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
  std::optional<double> variance;  ///< with n − 1
};

/// The result of a statistical test, whichever it is: one line of a table. Text, JSON, CSV and
/// reports are made from it. What is missing has its reason.
struct TestRow {
  std::string_view id;  ///< of the test: "welch", as in tables and on the command line

  std::string group1;  ///< the compared groups; the sign is group 1 − group 2
  std::string group2;
  std::optional<std::uint64_t> n1;  ///< of group 1; of pairs, people or cases where there is one n
  std::optional<std::uint64_t> n2;
  std::optional<std::array<GroupMoments, 2>> moments;  ///< of tests that compare means of groups

  NamedNumber estimate;
  std::optional<double> standardError;
  std::optional<Interval> interval;          ///< of the estimate
  std::optional<Interval> adjustedInterval;  ///< of the estimate, at the level of one of m tests

  NamedNumber statistic;     ///< may be infinite
  std::optional<double> df;  ///< degrees of freedom; of F the first
  std::optional<double> df2;

  std::optional<double> p;            ///< two-sided unless docs/statistics.md says otherwise
  std::optional<double> log10P;       ///< holds also where p is too small for a double
  bool isOfFamily = false;            ///< p is held to account for the size of a family
  std::optional<double> adjusted;     ///< p after the adjustment
  std::optional<bool> isSignificant;  ///< adjusted ≤ alpha

  NamedNumber effect;
  std::optional<Interval> effectInterval;
  Reason effectReason;  ///< why the effect is missing, where that has a reason of its own

  std::vector<NamedNumber> more;  ///< what only this test has: "p_exact", "epsilon"
  Reason reason;                  ///< why something above is missing; empty if nothing is

  /// An additional number; std::nullopt if the test does not have it, or it is not defined.
  std::optional<double> additional(std::string_view name) const {
    for (const auto& number : more) {
      if (number.name == name) return number.value;
    }
    return std::nullopt;
  }
};

/// The row of a test; nullptr where it is not among them.
const TestRow* findTest(std::span<const TestRow> rows, std::string_view id);

/// @throws std::out_of_range  where it is not among them.
const TestRow& testNamed(std::span<const TestRow> rows, std::string_view id);

}  // namespace analysis
