#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "analysis/numerics/interval.h"
#include "analysis/published/reported_number.h"

namespace analysis {

/// A group as a published table reports it.
struct PublishedGroup {
  std::string name;
  std::optional<std::uint64_t> n;  ///< std::nullopt if the publication does not state it
  ReportedNumber mean;
  ReportedNumber spread;  ///< the variance, or …
  bool isStandardDeviation = false;
};

/// A p value as it is printed: ".021", "< .017", "> .05".
struct PublishedP {
  enum class Relation { Equal, Below, Above };

  Relation relation = Relation::Equal;
  ReportedNumber number;

  std::string text() const;

  /// The p values that would be printed like this. A threshold is taken as it stands: below .017 is
  /// 0 … .017.
  Interval bounds(Reading reading) const;
};

struct PublishedComparison {
  std::size_t first = 0;  ///< in PublishedTable::groups
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
inline constexpr std::uint64_t kMostPublishedAnswers = 1000;

/// Reads two tables of comma-separated values:
///
///     group,n,mean,variance          group1,group2,p
///     I,36,4.1,1.3                   I,F,< .017
///     F,36,2.6,2.6                   I,K,.021
///     K,36,3.2,2.4                   K,F,.115
///
/// `n` may be missing, as a column or in a cell; `sd` may stand for `variance`. Numbers are copied
/// as they are printed, with their last zeros: how many decimals they have decides what follows.
///
/// @throws Error  in words, all problems at once.
PublishedTable readPublishedTable(std::string_view groupsCsv, std::string_view comparisonsCsv);

}  // namespace analysis
