#include "study/results_text.h"

#include <algorithm>

#include <fmt/format.h>

namespace study {
namespace {

/// How many columns a text takes on the screen; bytes that go on with a character take none.
std::size_t width(const std::string& text) {
  return static_cast<std::size_t>(std::count_if(text.begin(), text.end(), [](char c) {
    return (static_cast<unsigned char>(c) & 0xc0) != 0x80;
  }));
}

std::string padded(const std::string& text, std::size_t columns, bool toTheRight = false) {
  const std::string space(columns > width(text) ? columns - width(text) : 0, ' ');
  return toTheRight ? space + text : text + space;
}

class Writer {
 public:
  Writer(Study& study, const Results& results)
      : protocol_(study.protocol().protocol), results_(results) {}

  std::string all() {
    head();
    for (const auto& family : results_.families) {
      means(family);
      comparisons(family);
    }
    if (!results_.votes.empty()) votes();
    return text_;
  }

 private:
  void line(const std::string& words) { text_ += words + "\n"; }

  const std::string& titleOf(const std::string& condition) const {
    return protocol_.condition(condition)->title;
  }
  const std::string& cohortTitle(const std::string& cohort) const {
    return protocol_.cohort(cohort)->title.in("en");
  }

  void head() {
    line(protocol_.study.title);
    if (results_.runMode == RunMode::Simulated) {
      line("SIMULATED: nobody took part; these numbers say nothing about any method.");
    }
    if (results_.runMode == RunMode::Pilot) line("PILOT: not for publication.");
    for (const auto& flow : results_.flow) {
      const int others = flow.declined + flow.withdrawn + flow.rejected + flow.abortedHardware;
      line(fmt::format(
          "{}: {} enrolled, {} completed, {} in progress, {} left or excluded",
          cohortTitle(flow.cohort),
          flow.enrolled,
          flow.completed,
          flow.inProgress,
          others));
    }
  }

  void means(const FamilyResult& family) {
    line("\n" + family.family.title + ": mean μ and variance σ² of the keyed answers");
    std::string heading = padded("", 40);
    for (const auto& condition : family.cohorts.front().conditions) {
      heading += padded(titleOf(condition.name), 22, true);
    }
    line(heading);
    for (const auto& cohort : family.cohorts) {
      std::string row = padded(cohortTitle(cohort.cohort), 40);
      for (const auto& condition : cohort.conditions) {
        row += padded(
            fmt::format(
                "{} / {} (n={})",
                rounded(condition.counts.mean(), 1),
                rounded(condition.counts.variance(), 1),
                condition.counts.total()),
            22,
            true);
      }
      line(row);
    }
  }

  void comparisons(const FamilyResult& family) {
    const bool isCorrected = family.family.correction == protocols::CorrectionType::Bonferroni;
    line(fmt::format(
        "\n{}: Welch's t-tests{}, alpha = {}",
        family.family.title,
        isCorrected ? " with Bonferroni correction" : "",
        family.family.alpha));
    for (const auto& cohort : family.cohorts) {
      line(
          cohortTitle(cohort.cohort) +
          (cohort.comparisons.alphaPerTest
               ? fmt::format(" (alpha per test {:.4f})", *cohort.comparisons.alphaPerTest)
               : ""));
      for (const auto& row : cohort.comparisons.rows) comparison(row);
    }
  }

  void comparison(const analysis::PairwiseComparison& row) {
    const auto& w = row.welch;
    std::string words = "  " + padded(titleOf(row.group1) + " vs. " + titleOf(row.group2), 38);
    if (!w.p) {
      line(words + "not defined: " + w.reason);
      return;
    }
    words += fmt::format(
        "difference {:>6.2f}, t({:.2f}) = {:>6.2f}, p = {:<7} adjusted p = {:<7}",
        *w.difference,
        *w.degreesOfFreedom,
        *w.t,
        pInWords(w.p),
        pInWords(row.adjustedP));
    line(words + (row.isSignificant.value_or(false) ? " significant" : ""));
  }

  void votes() {
    line("\nPreferences: how many named each method");
    for (const auto& vote : results_.votes) {
      std::string row = padded(cohortTitle(vote.cohort), 40) + padded("after " + vote.block, 22);
      for (const auto& share : vote.votes.shares()) {
        row += padded(titleOf(share.option) + " " + std::to_string(share.votes), 18);
      }
      line(row);
    }
  }

  const protocols::Protocol& protocol_;
  const Results& results_;
  std::string text_;
};

}  // namespace

std::string rounded(const std::optional<double>& value, int digits) {
  return value ? fmt::format("{:.{}f}", *value, digits) : "–";
}

std::string pInWords(const std::optional<double>& p) {
  if (!p) return "–";
  if (*p < 0.001) return "< .001";
  if (*p >= 0.9995) return "1.000";
  return fmt::format("{:.3f}", *p).substr(1);
}

std::string resultsAsText(Study& study, const Results& results) {
  return Writer(study, results).all();
}

}  // namespace study
