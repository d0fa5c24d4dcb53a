#pragma once

#include <array>
#include <string>

#include "study/report/report_section.h"

// The parts of a page about one study. Each is HTML, and may be empty.
namespace study::report {

/// What the study is, and whether its participants were real or simulated.
std::string headAsHtml(const ReportSection& section);

/// How many took part, by cohort.
std::string participantsAsHtml(const ReportSection& section);

/// The answers, by family.
std::string familiesAsHtml(const ReportSection& section);

/// The preferences, with their figure.
std::string preferencesAsHtml(const ReportSection& section);

/// The summaries of scored questionnaires; empty if there are none.
std::string instrumentsAsHtml(const ReportSection& section);

/// The force of each alternative, and the quality of its rendering.
std::string renderingAsHtml(const ReportSection& section);

/// The warnings of the protocol's validation about the design.
std::string warningsAsHtml(const ReportSection& section);

/// The methods: procedure, sources and software.
std::string methodsAsHtml(const ReportSection& section);

/// All parts, in the order of the page.
inline constexpr auto kStudyParts = std::to_array<std::string (*)(const ReportSection&)>(
    {headAsHtml,
     participantsAsHtml,
     familiesAsHtml,
     preferencesAsHtml,
     instrumentsAsHtml,
     renderingAsHtml,
     warningsAsHtml,
     methodsAsHtml});

}  // namespace study::report
