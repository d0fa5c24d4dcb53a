#pragma once

#include <cmath>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "study/report/report_section.h"

// The parts of a page about one study. Each is HTML, and may be empty.
namespace study::report {

/// Whether participants were real or simulated, and what the study asks.
std::string headAsHtml(const ReportSection& section);

/// The number of participants, by cohort.
std::string participantsAsHtml(const ReportSection& section);

/// What was found, in one or two plain sentences without statistics; empty without answers.
std::string verdictOf(const ReportSection& section);

/// The answer: one figure, one table, a sentence for each cohort, and what weakens it.
std::string answerAsHtml(const ReportSection& section);

/// The family whose figure is shown beside the answer: the first one with answers; nullptr if there
/// is none.
const FamilyResult* mainFamily(const ReportSection& section);

/// A declared comparison, with the numbers that its family's test gives.
struct Declared {
  std::string group1;
  std::string group2;
  const analysis::TestRow* difference;  ///< has estimate, interval and effect
  const analysis::TestRow* test;        ///< has p

  bool isDefined() const { return difference->estimate.value && test->p; }
  double effect() const { return std::abs(difference->effect.value.value_or(0.0)); }
};
std::vector<Declared> declaredIn(const FamilyResult& family, const CohortResult& cohort);

/// Whether any participant of the cohort answered.
bool hasAnswers(const CohortResult& cohort);

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

/// What of the answer is about something else than the methods; empty if nothing is.
std::string caveatsOfRenderingAsHtml(const ReportSection& section);

/// What weakens the answer, in at most three points; empty if nothing does.
std::string weaknessesAsHtml(const ReportSection& section);

/// All of that, explained: remarks on the data, and the design by the protocol's validation.
std::string limitationsAsHtml(const ReportSection& section);

/// What the study adds to the validity of the simulator, by source of evidence.
std::string validityAsHtml(const ReportSection& section);

/// The methods: procedure, sources and software.
std::string methodsAsHtml(const ReportSection& section);

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

}  // namespace study::report
