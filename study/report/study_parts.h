#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/report/report_section.h"

// The parts of a page about one study. Each is HTML, and may be empty.
namespace study::report {

class Citations;

/// What tables say, in the order in which a reader needs it.
struct Answer {
  std::string finding;                 ///< the headline: two or three short sentences
  std::string more{};                  ///< where, how much, and what was not tested; may be empty
  std::vector<std::string> caveats{};  ///< what weakens it, and what it does not say
};

/// Whether participants were real or simulated, and what the study asks.
std::string headAsHtml(const ReportSection& section);

/// The number of participants, by cohort.
std::string participantsAsHtml(const ReportSection& section);

/// What was found, in plain sentences without statistics; empty without answers.
/// The finding is of the declared test, or what was named most often.
Answer conclusionOf(const ReportSection& section);

/// All of its sentences.
std::string verdictOf(const ReportSection& section);

/// Whether a declared test that was made takes several answers of one person as those of several
/// people.
bool areAnswersPooled(const ReportSection& section);

/// The condition of the family with the highest mean of all answers; empty without answers.
std::string highestRatedIn(const FamilyResult& family);

/// The answer: one figure, one table, a sentence for each cohort, and what weakens it.
std::string answerAsHtml(const ReportSection& section);

/// The family whose figure is shown beside the answer: the first one with answers; nullptr if there
/// is none.
const FamilyResult* mainFamily(const ReportSection& section);

/// A declared comparison, with the numbers that its family's test gives.
struct Declared {
  std::string group1;
  std::string group2;
  const analysis::TestRow* difference;    ///< has estimate, interval and effect
  const analysis::TestRow* test;          ///< has p
  const analysis::TestRow* withinPeople;  ///< the paired t-test of participants' means
  std::size_t people;                     ///< number of participants whose answers it compares
  /// Of the test that the difference is smaller than the family's bound; std::nullopt without one.
  std::optional<double> equivalenceP = std::nullopt;

  bool isDefined() const { return difference->estimate.value && test->p; }
  bool has(const std::string& condition) const {
    return group1 == condition || group2 == condition;
  }
};
std::vector<Declared> declaredIn(const FamilyResult& family, const CohortResult& cohort);

/// The declared comparisons of a cohort in which others were tested, and these could not be.
std::vector<Declared> leftOutIn(const FamilyResult& family, const CohortResult& cohort);

/// The fewest and the most participants of a declared comparison that was tested; if none was, how
/// many answered.
std::pair<std::size_t, std::size_t> peopleComparedIn(
    const FamilyResult& family, const CohortResult& cohort);

/// The alternative that the sentences on a family, and the figure beside them, compare with the
/// others; empty if they are about all comparisons.
std::string mainAlternativeOf(const FamilyResult& family);

/// Whether any participant of the cohort answered.
bool hasAnswers(const CohortResult& cohort);

/// One family of questions: the answers, the tests within people, between cohorts and, where they
/// are declared, of pooled answers, the effect of order, and the reliability of the scale. The
/// declared test is confirmatory, all others are exploratory.
/// @param figures  of the family; empty if none were painted.
std::string familyAsHtml(
    const ReportSection& section, const FamilyResult& family, const FamilyFigures& figures);

/// A family's comparisons within people and between cohorts.
/// @param figure  of the effects.
std::string withinAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure);

/// A family's differences at each site and pooled over sites; empty if there is only one site.
/// @param figure  the forest plot.
std::string sitesAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure);

/// The preferences, with their figure.
std::string preferencesAsHtml(const ReportSection& section);

/// The summaries of scored questionnaires; empty if there are none.
std::string instrumentsAsHtml(const ReportSection& section);

/// Every answered item by itself, except texts; empty if there are none.
std::string itemsAsHtml(const ReportSection& section);

/// What participants wrote, by item and alternative; empty if they wrote nothing.
std::string quotesAsHtml(const ReportSection& section);

/// The force of each alternative, and the quality of its rendering.
std::string renderingAsHtml(const ReportSection& section);

/// The caveats on the rendering, because of which the answer is about something other than the
/// methods; empty if there are none.
std::string caveatsOfRenderingAsHtml(const ReportSection& section);

/// The titles of what weakens the answer, the heaviest first; empty without participants.
std::string weaknessesAsHtml(const ReportSection& section);

/// All caveats and weaknesses, explained: remarks on the data, and on the design from the
/// validation of the protocol; and what was looked for and not found. Empty without participants.
std::string limitationsAsHtml(const ReportSection& section);

/// The flags that limitationsAsHtml() explains, with their sources.
std::vector<const analysis::Flag*> explainedFlags(const ReportSection& section);

/// A list of everything by which a reader of the protocol could tell conditions apart in spite of
/// their labels: "the number of an alternative and its position"; may be empty.
std::string disclosuresInWords(const ReportSection& section);

/// The citation of questionnaires that Palpate words itself, and that of a laboratory's own
/// (docs/questionnaire-format.md).
inline constexpr std::string_view kPalpatesWording = "Palpate's own wording.";
inline constexpr std::string_view kOwnWording = "Own wording.";

/// What the study adds to the validity of the simulator, by source of evidence.
std::string validityAsHtml(const ReportSection& section);

/// The kind of sources that are shown on the screen; all other kinds are felt.
inline constexpr std::string_view kShownSourceKind = "anatomy";

/// The conditions that come from parameters of the protocol alone.
std::vector<std::string> withoutSource(const ReportSection& section);

/// The methods: apparatus, procedure, analysis, sources and software, with the works that they
/// cite.
std::string methodsAsHtml(const ReportSection& section);

/// What later versions of the protocol did to its families after the first participant had begun, a
/// sentence for each change.
std::vector<std::string> planChangesInWords(const ReportSection& section);

/// What the protocol declares, and the statistical tests that the report has, with their sources.
/// @param citations  gets the works that are cited.
std::string statisticsAsHtml(const ReportSection& section, Citations& citations);

/// A part of the appendix, which is collapsed on the page.
struct AppendixPart {
  std::string heading;
  std::string html;
};

/// The parts of the appendix that every study may have, in the order of the page. They follow the
/// parts about families.
struct CommonPart {
  std::string_view heading;  ///< in English
  std::string (*html)(const ReportSection& section);
};
std::span<const CommonPart> commonParts() noexcept;

/// All parts that are not empty, in the order of the page.
std::vector<AppendixPart> appendixOf(const ReportSection& section);

// The figures of a family that may be shown beside the answer, with their captions in English.

inline constexpr std::string_view kAnswersCaption =
    "How often each point was chosen. Answers to negative statements are reversed, so that right "
    "is good; the middle of the scale is centred. Numbers are counts, where there is room; n is "
    "all answers.";

inline constexpr std::string_view kParticipantMeansCaption =
    "What participants thought, by the mean of all that each answered about a method: dots are "
    "single people, where there are at most fifty; the upright line is the median, the diamond the "
    "mean; the box, of ten people or more, holds the middle half.";

/// The largest number of points of a scale whose answers are counted point by point.
inline constexpr int kMostBars = 11;

/// Whether the answers to a family are counted point by point.
inline bool isShownByPoint(const FamilyResult& family) {
  const auto& table = family.cohorts.front().table;
  return table.isPointScale && table.highest - table.lowest < kMostBars;
}

/// The figure beside the answer.
enum class MainFigure {
  Differences,       ///< for a declared test within participants
  Answers,           ///< counts per point; for the pooled test, or if nothing is tested
  ParticipantMeans,  ///< means of participants; in place of Answers if the scale has many points
};

/// The short name of a test, for a table: "Paired t".
std::string_view shortNameOf(std::string_view test);

/// The caption of the figure of differences, in the language of the report.
std::string differencesCaption(const FamilyResult& family, const words::Words& words);

/// Whether the differences of a comparison could be normal, as the paired t-test takes them.
analysis::ShapiroWilkResult normalityOf(
    const CohortResult& cohort, const analysis::WithinComparison& comparison);

/// The figure to show beside the answer for @p family; std::nullopt if another family is the main
/// one.
std::optional<MainFigure> mainFigureOf(const ReportSection& section, const FamilyResult& family);

}  // namespace study::report
