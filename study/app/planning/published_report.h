#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/published/answer_lattice.h"
#include "analysis/published/consistent_sizes.h"
#include "analysis/published/published_check.h"
#include "analysis/published/published_table.h"

namespace study::app {

/// The options for checking a published table.
struct PublishedTableOptions {
  /// Range of sizes to try, equal for all groups; without it the sizes that the table states.
  std::optional<std::uint64_t> fewest;
  std::optional<std::uint64_t> most;
  /// The scale of the answers; without it, sets of whole answers are not searched for.
  std::optional<analysis::AnswerScale> scale;
};

/// The results of checking a published table.
struct PublishedReport {
  analysis::PublishedTable table;
  PublishedTableOptions tableOptions;
  /// For every convention, the check with the stated sizes; empty if the table states none.
  std::vector<analysis::ConventionCheck> statedSizeChecks;
  /// For every convention, the check with equal sizes of all groups; empty if not requested.
  std::vector<analysis::ConventionCheck> equalSizeChecks;
  /// For every convention, the sizes for which a set of whole answers gives the table's values;
  /// empty without a scale.
  std::vector<analysis::ConsistentSizes> consistentSizes;
};

/// @throws UserError  if sizes are missing or there are too many combinations.
PublishedReport checkPublishedTable(
    const analysis::PublishedTable& table, const PublishedTableOptions& tableOptions);

std::string publishedReportAsText(const PublishedReport& report);
std::string publishedReportAsJson(const PublishedReport& report);

}  // namespace study::app
