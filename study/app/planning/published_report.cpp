#include "study/app/planning/published_report.h"

#include <algorithm>
#include <stdexcept>
#include <string>

namespace study::app {
namespace {

using analysis::GroupSizes;
using analysis::PublishedTable;

constexpr std::uint64_t kMostSizes = 100;

/// The group sizes that the table states; std::nullopt if one is missing.
std::optional<GroupSizes> statedSizes(const PublishedTable& table) {
  GroupSizes sizes;
  for (const auto& group : table.groups) {
    if (!group.n) return std::nullopt;
    sizes.push_back(*group.n);
  }
  return sizes;
}

/// The combinations of group sizes to try.
std::vector<GroupSizes> sizesToTry(
    const PublishedTable& table, const PublishedTableOptions& tableOptions) {
  std::vector<GroupSizes> all;
  for (const auto& group : table.groups) {
    auto& sizes = all.emplace_back();
    if (!tableOptions.fewest) {
      sizes.push_back(*group.n);
      continue;
    }
    for (std::uint64_t n = *tableOptions.fewest; n <= *tableOptions.most; ++n) sizes.push_back(n);
  }
  return all;
}

void findConsistentSizes(PublishedReport& report) {
  const auto sizes = sizesToTry(report.table, report.tableOptions);
  std::uint64_t most = 0;
  for (const auto& groupSizes : sizes) most = std::max(most, groupSizes.back());
  try {
    const analysis::AnswerLattice lattice(*report.tableOptions.scale, most);
    for (const auto& convention : analysis::publishedConventions()) {
      report.consistentSizes.push_back(
          analysis::consistentSizes(report.table, sizes, lattice, convention));
    }
  } catch (const std::invalid_argument& error) {
    throw base::UserError(
        std::string(error.what()) +
        ": try fewer sizes (--sizes), or leave the scale out (--scale)");
  }
}

}  // namespace

PublishedReport checkPublishedTable(
    const PublishedTable& table, const PublishedTableOptions& tableOptions) {
  const auto stated = statedSizes(table);
  if (!stated && !tableOptions.fewest) {
    throw base::UserError(
        "the table does not state the size of every group: add a column n, or say which sizes to "
        "try, for instance --sizes 24 36");
  }
  if (tableOptions.fewest && *tableOptions.most - *tableOptions.fewest >= kMostSizes) {
    throw base::UserError(
        "those are too many sizes to try at once: at most " + std::to_string(kMostSizes));
  }
  PublishedReport report{.table = table, .tableOptions = tableOptions};
  if (tableOptions.scale) findConsistentSizes(report);
  for (const auto& convention : analysis::publishedConventions()) {
    if (stated)
      report.statedSizeChecks.push_back(analysis::checkConvention(table, *stated, convention));
    if (!tableOptions.fewest) continue;
    for (std::uint64_t n = *tableOptions.fewest; n <= *tableOptions.most; ++n) {
      report.equalSizeChecks.push_back(
          analysis::checkConvention(table, GroupSizes(table.groups.size(), n), convention));
    }
  }
  return report;
}

}  // namespace study::app
