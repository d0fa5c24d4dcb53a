#pragma once

#include <algorithm>
#include <string_view>

#include "study/report/report_section.h"
#include "study/report/study_parts.h"

// The figures of a family that may be shown beside the answer, with their captions in English.
namespace study::report {

inline constexpr std::string_view kAnswersCaption =
    "How often each point was chosen. Answers to negative statements are reversed, so that right "
    "is good; the middle of the scale is centred. Numbers are counts.";

inline constexpr std::string_view kPeopleCaption =
    "What participants thought, by the mean of all that each answered about a method: the density; "
    "the box holds the middle half, with the median; the diamond is the mean. Dots are single "
    "people, where there are fewer than ten.";

inline constexpr std::string_view kFewPeopleCaption =
    "What participants thought: a dot is the mean of all that one person answered about a method; "
    "the box holds the middle half, with the median; the diamond is the mean.";

/// Whether the figure of participants shows densities. With fewer than five participants a density
/// would suggest more data than there are.
inline bool hasDensities(const FamilyResult& family) {
  constexpr std::size_t kFewest = 5;
  return std::ranges::any_of(family.cohorts, [](const auto& cohort) {
    return hasAnswers(cohort) && cohort.table.participants.size() >= kFewest;
  });
}

inline std::string_view peopleCaption(const FamilyResult& family) {
  return hasDensities(family) ? kPeopleCaption : kFewPeopleCaption;
}

inline constexpr std::string_view kDifferencesCaption =
    "Mean differences within people with their intervals at 1 − α.";

inline constexpr std::string_view kShadedDifferencesCaption =
    "Mean differences within people with their intervals at 1 − α. Shaded are differences that "
    "count as none.";

inline constexpr std::string_view kCorrectedDifferencesCaption =
    "Mean differences within people: the thick line is the interval at 1 − α, the thin one at 1 − "
    "α/m, as wide as Bonferroni’s correction asks of m comparisons.";

inline constexpr std::string_view kShadedCorrectedDifferencesCaption =
    "Mean differences within people: the thick line is the interval at 1 − α, the thin one at 1 − "
    "α/m, as wide as Bonferroni’s correction asks of m comparisons. Shaded are differences that "
    "count as none.";

/// The largest number of points of a scale whose answers are counted point by point.
inline constexpr int kMostBars = 11;

/// Whether the answers to a family are counted point by point.
inline bool isShownByPoint(const FamilyResult& family) {
  const auto& table = family.cohorts.front().table;
  return table.isOfPoints && table.highest - table.lowest < kMostBars;
}

/// The figure beside the answer.
enum class MainFigure {
  Differences,  ///< of the declared test within people
  Answers,      ///< counts per point; for the pooled test, or if nothing is tested
  People,       ///< means of participants; in place of Answers if the scale has many points
};

/// The caption of the figure of differences.
std::string_view differencesCaption(const FamilyResult& family);

/// The figure to show beside the answer for @p family; std::nullopt if another family is the main
/// one.
std::optional<MainFigure> mainFigureOf(const ReportSection& section, const FamilyResult& family);

}  // namespace study::report
