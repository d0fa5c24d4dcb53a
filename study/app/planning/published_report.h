#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "analysis/published/answer_lattice.h"
#include "analysis/published/fitting_sizes.h"
#include "analysis/published/published_check.h"
#include "analysis/published/published_table.h"

namespace study::app {

/// What is asked of a published table beside its own numbers.
struct PublishedQuestion {
  /// Sizes of the groups to be tried, from … to; without them those that the table states.
  std::optional<std::uint64_t> fewest;
  std::optional<std::uint64_t> most;
  /// What the answers were given on; without it whole answers are not looked for.
  std::optional<analysis::AnswerScale> scale;
};

/// Everything that was found about a published table.
struct PublishedReport {
  analysis::PublishedTable table;
  PublishedQuestion question;
  /// At the sizes that the table states, by every convention; empty where it states none.
  std::vector<analysis::ConventionCheck> atStated;
  /// At sizes that are the same in every group, by every convention; empty where none were asked
  /// for.
  std::vector<analysis::ConventionCheck> atEqual;
  /// Whole answers, by every convention; empty without a scale.
  std::vector<analysis::FittingSizes> wholeAnswers;
};

/// @throws analysis::Error  in words, where sizes are missing or there is too much to try.
PublishedReport examine(const analysis::PublishedTable& table, const PublishedQuestion& question);

std::string publishedReportAsText(const PublishedReport& report);
std::string publishedReportAsJson(const PublishedReport& report);

}  // namespace study::app
