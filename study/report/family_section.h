#pragma once

#include <string>

#include "study/report/report_section.h"

namespace study::report {

/// One family of questions: the answers, the tests of the punch paper, the comparisons within
/// people and between cohorts, the effect of order, the reliability of the scale, and notes. The
/// declared test is confirmatory, all others are exploratory.
/// @param figures  of the family; empty if none were painted.
std::string familyAsHtml(
    const ReportSection& section, const FamilyResult& family, const FamilyFigures& figures);

}  // namespace study::report
