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
  /// Sizes to try, the same for all groups; without them the sizes stated by the table.
  std::optional<std::uint64_t> fewest;
  std::optional<std::uint64_t> most;
  /// The scale of the answers; without it no sets of whole answers are searched for.
  std::optional<analysis::AnswerScale> scale;
};

/// All findings on a published table.
struct PublishedReport {
  analysis::PublishedTable table;
  PublishedTableOptions question;
  /// With the stated sizes, for every convention; empty if the table states none.
  std::vector<analysis::ConventionCheck> atStated;
  /// With equal sizes of all groups, for every convention; empty if none were requested.
  std::vector<analysis::ConventionCheck> atEqual;
  /// Sets of whole answers that give the table's values, for every convention; empty without a
  /// scale.
  std::vector<analysis::ConsistentSizes> wholeAnswers;
};

/// @throws UserError  if sizes are missing or there are too many combinations.
PublishedReport checkPublishedTable(
    const analysis::PublishedTable& table, const PublishedTableOptions& question);

std::string publishedReportAsText(const PublishedReport& report);
std::string publishedReportAsJson(const PublishedReport& report);

}  // namespace study::app
