#pragma once

#include <array>
#include <string>

#include "study/report/report_section.h"

// The parts of a page about one study. Each is HTML, and may be empty.
namespace study::report {

/// What the study is, and whether its participants were real or simulated.
std::string headAsHtml(const ReportSection& section);

/// Who took part, cohort by cohort.
std::string participantsAsHtml(const ReportSection& section);

/// What participants answered, family by family.
std::string familiesAsHtml(const ReportSection& section);

/// Who preferred what, with the figure.
std::string preferencesAsHtml(const ReportSection& section);

/// What the questionnaires that are scored came to; empty where there are none.
std::string instrumentsAsHtml(const ReportSection& section);

/// What each alternative felt like, and how well it was rendered.
std::string renderingAsHtml(const ReportSection& section);

/// What the check of the protocol says about the design.
std::string warningsAsHtml(const ReportSection& section);

/// What was done, for a methods section; and with what it was computed.
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
