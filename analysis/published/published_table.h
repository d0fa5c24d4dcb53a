#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/data/csv_table.h"
#include "analysis/numerics/interval.h"

namespace analysis {

/// How a publication shortened its numbers to the printed digits.
enum class RoundingRule {
  Rounded,    ///< to the nearest; a half may have been rounded up or down
  Truncated,  ///< cut off, towards zero
};

/// A number as it is printed: its digits, and how many of them are decimals. "4.10" is more precise
/// than "4.1".
struct ReportedNumber {
  static constexpr int kMostDigits = 9;

  std::int64_t digits = 0;  ///< 410 for "4.10"
  int decimals = 0;         ///< 2 for "4.10"

  double value() const;
  /// The number with as many decimals as were printed.
  std::string text() const;

  /// The numbers that would be printed like this: x ± half a unit of the last digit if numbers are
  /// rounded; from x to one unit further from zero if they are truncated.
  Interval bounds(RoundingRule rounding) const;

  /// Whether numerator / denominator would be printed like this. Computed exactly, in whole
  /// numbers.
  /// @param denominator  positive.
  bool matchesQuotient(
      std::int64_t numerator, std::int64_t denominator, RoundingRule rounding) const;

  /// Whether √(numerator / denominator) would be printed like this.
  /// @param numerator  not negative.  @param denominator  positive.
  bool matchesRootOf(std::int64_t numerator, std::int64_t denominator, RoundingRule rounding) const;
};

/// Reads "4.1", ".021", "-3" or, where the mark allows it, "4,1"; std::nullopt for other text and
/// for more than kMostDigits digits.
std::optional<ReportedNumber> reportedNumber(
    std::string_view text, base::DecimalMark mark = base::DecimalMark::Point);

/// A group as a published table reports it.
struct PublishedGroup {
  std::string name;
  std::optional<std::uint64_t> n;  ///< std::nullopt if the publication does not state it
  ReportedNumber mean;
  ReportedNumber spread;  ///< variance, or standard deviation if isStandardDeviation
  bool isStandardDeviation = false;
};

/// A p value as it is printed: ".021", "< .017", "> .05".
struct PublishedP {
  enum class Relation { Equal, Below, Above };

  Relation relation = Relation::Equal;
  ReportedNumber number;

  std::string text() const;

  /// The p values that would be printed like this. A threshold is exact: "< .017" gives 0 … .017.
  Interval bounds(RoundingRule rounding) const;
};

struct PublishedComparison {
  std::size_t first = 0;  ///< index into PublishedTable::groups
  std::size_t second = 0;
  PublishedP p;
};

/// One row of a published table: groups, and the p values of their comparisons.
struct PublishedTable {
  std::vector<PublishedGroup> groups;
  std::vector<PublishedComparison> comparisons;
};

/// How many groups and comparisons a table may have.
inline constexpr std::size_t kMostPublishedGroups = 8;
inline constexpr std::size_t kMostPublishedComparisons = 28;
/// The largest group that can be checked.
inline constexpr std::uint64_t kLargestPublishedGroup = 1000;

/// Reads two tables of comma-separated values:
///
///     group,n,mean,variance          group1,group2,p
///     I,36,4.1,1.3                   I,F,< .017
///     F,36,2.6,2.6                   I,K,.021
///     K,36,3.2,2.4                   K,F,.115
///
/// The column `n` or its cells may be missing; a column `sd` may replace `variance`. Numbers must
/// be copied as they are printed, with trailing zeros: the number of decimals determines their
/// range.
///
/// @throws UserError  listing the first ten problems.
PublishedTable readPublishedTable(std::string_view groupsCsv, std::string_view comparisonsCsv);

}  // namespace analysis
