#include <algorithm>

#include <fmt/format.h>

#include "study/app/planning/published_report.h"
#include "study/results/apa_text.h"

namespace study::app {
namespace {

using analysis::ConventionCheck;
using analysis::PublishedTable;

std::string shortP(double p) {
  if (p < 0.00005) return p == 0.0 ? "0" : "<.0001";
  if (p >= 0.99995) return "1";
  return rounded(p, 4).substr(1);
}

std::string namesAndSizes(const PublishedTable& table, const analysis::GroupSizes& sizes) {
  std::string words;
  for (std::size_t g = 0; g < sizes.size(); ++g) {
    words += fmt::format("{}{} {}", g == 0 ? "" : ", ", table.groups[g].name, sizes[g]);
  }
  return words;
}

/// Numbers as a list of ranges: "24–27, 30".
std::string asRanges(const std::vector<std::uint64_t>& numbers) {
  std::string words;
  for (std::size_t i = 0; i < numbers.size();) {
    std::size_t last = i;
    while (last + 1 < numbers.size() && numbers[last + 1] == numbers[last] + 1) ++last;
    words += (words.empty() ? "" : ", ") + std::to_string(numbers[i]);
    if (last > i) words += "–" + std::to_string(numbers[last]);
    i = last + 1;
  }
  return words.empty() ? "none" : words;
}

std::string verdict(const analysis::ComparisonCheck& check, const analysis::Interval& printed) {
  if (check.isAttainable) return "may be";
  const bool isTooLarge = printed.low > check.attainable.high;
  return fmt::format(
      "CANNOT BE: {} {}",
      isTooLarge ? "at most" : "at least",
      shortP(isTooLarge ? check.attainable.high : check.attainable.low));
}

std::string comparisonTable(const PublishedTable& table, const ConventionCheck& check) {
  std::string text = fmt::format(
      "n = {}; {}:\n  {:<24} {:>10}   {:<18} {}\n",
      namesAndSizes(table, check.sizes),
      analysis::describe(check.convention),
      "comparison",
      "printed p",
      "attainable p",
      "verdict");
  for (std::size_t i = 0; i < table.comparisons.size(); ++i) {
    const auto& [first, second, p] = table.comparisons[i];
    const auto& row = check.comparisons[i];
    text += fmt::format(
        "  {:<24} {:>10}   {:<18} {}\n",
        table.groups[first].name + " – " + table.groups[second].name,
        p.text(),
        shortP(row.attainable.low) + " … " + shortP(row.attainable.high),
        verdict(row, p.bounds(check.convention.rounding)));
  }
  if (check.areAllAttainable()) {
    text += check.row ? "  One mean and one variance for each group give all p at once.\n"
                      : "  Each p may be for itself; no means and variances were found that give "
                        "all of them at once.\n";
  }
  return text + "\n";
}

/// The check with the stated sizes: a table of the printed and the computed numbers, and the
/// conventions that reproduce the whole row.
std::string statedPart(const PublishedReport& report) {
  std::string text = comparisonTable(report.table, report.statedSizeChecks.front());
  std::vector<std::string> fitting;
  for (const auto& check : report.statedSizeChecks) {
    if (check.row) fitting.push_back(analysis::describe(check.convention));
  }
  text += fmt::format(
      "Of {} conventions {} the whole row at these sizes{}\n",
      report.statedSizeChecks.size(),
      fitting.empty() ? "none explains" : fmt::format("{} explain", fitting.size()),
      fitting.empty() ? "." : ":");
  for (const auto& words : fitting) text += "  " + words + "\n";
  return text + "\n";
}

std::string equalPart(const PublishedReport& report) {
  std::string text = fmt::format(
      "Sizes from {} to {}, the same in every group, that explain the whole row (real numbers):\n",
      *report.tableOptions.fewest,
      *report.tableOptions.most);
  for (const auto& convention : analysis::publishedConventions()) {
    std::vector<std::uint64_t> sizes;
    for (const auto& check : report.equalSizeChecks) {
      if (check.convention == convention && check.row) sizes.push_back(check.sizes.front());
    }
    text += fmt::format("  {:<60} {}\n", analysis::describe(convention), asRanges(sizes));
  }
  return text + "\n";
}

std::string describeFits(const PublishedTable& table, const analysis::ConsistentSizes& fits) {
  if (fits.triedCombinations == 1) return fits.fitting.empty() ? "no answers fit" : "answers fit";
  if (fits.fitting.empty()) return fmt::format("none of {} fits", fits.triedCombinations);
  const auto equal = fits.equalSizes();
  return fmt::format(
      "{} of {} fit, {}; fewest missing: {}",
      fits.fitting.size(),
      fits.triedCombinations,
      equal.empty() ? "none with equal sizes" : "equal sizes " + asRanges(equal),
      namesAndSizes(table, *fits.largestFittingSizes()));
}

/// Answers as text: "2 × 1, 7 × 3.5" are two answers of 1 and seven of 3.5.
std::string formatAnswers(
    const analysis::AnswerScale& scale, const std::vector<std::uint64_t>& times) {
  std::string words;
  for (std::size_t u = 0; u < times.size(); ++u) {
    if (times[u] == 0) continue;
    words += fmt::format(
        "{}{} × {:g}",
        words.empty() ? "" : ", ",
        times[u],
        scale.lowest + static_cast<double>(u) / scale.parts);
  }
  return words;
}

/// A data set that gives the values of the row, or a sentence that there is none.
std::string describeExample(const PublishedReport& report) {
  const auto& all = report.consistentSizes;
  const auto found =
      std::ranges::find_if(all, [](const auto& fits) { return !fits.exampleAnswers.empty(); });
  if (found == all.end()) {
    return fmt::format(
        "  PROVED: no answers on this scale print the row, at any of {} combinations of sizes and "
        "by any of {} conventions:\n  every sum and sum of squares of answers was tried.\n",
        all.front().triedCombinations,
        all.size());
  }
  std::string text = fmt::format(
      "  One data set that prints the row ({}):\n", analysis::describe(found->convention));
  for (std::size_t g = 0; g < found->exampleAnswers.size(); ++g) {
    text += fmt::format(
        "    {}: {}\n",
        report.table.groups[g].name,
        formatAnswers(*report.tableOptions.scale, found->exampleAnswers[g]));
  }
  return text;
}

std::string consistentSizesPart(const PublishedReport& report) {
  const auto& scale = *report.tableOptions.scale;
  std::string text = fmt::format(
      "Answers on {} … {}{} (sums and sums of squares are whole; every combination of sizes):\n",
      scale.lowest,
      scale.highest,
      scale.parts == 1 ? "" : fmt::format(" in steps of 1/{}", scale.parts));
  const auto& usual = report.consistentSizes.front();
  for (std::size_t g = 0; g < report.table.groups.size(); ++g) {
    text += fmt::format(
        "  mean and variance of {} alone: {}\n",
        report.table.groups[g].name,
        usual.possibleSizes[g].empty() ? "no size" : "n = " + asRanges(usual.possibleSizes[g]));
  }
  for (const auto& fits : report.consistentSizes) {
    text += fmt::format(
        "  {:<60} {}\n", analysis::describe(fits.convention), describeFits(report.table, fits));
  }
  return text + describeExample(report) + "\n";
}

}  // namespace

std::string publishedReportAsText(const PublishedReport& report) {
  std::string text =
      "Do the printed p values follow from the printed means, variances and sizes?\n\n";
  if (!report.statedSizeChecks.empty()) text += statedPart(report);
  if (!report.equalSizeChecks.empty()) text += equalPart(report);
  if (!report.consistentSizes.empty()) {
    text += consistentSizesPart(report);
  } else {
    text +=
        "Whole answers were not looked for: say what scale they were given on, for instance "
        "--scale 1 5.\n";
  }
  return text;
}

}  // namespace study::app
