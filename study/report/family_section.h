#pragma once

#include <string>

#include "study/report/report_section.h"

namespace study::report {

/// One family of questions: what was answered, the tests of the punch paper, the comparisons within
/// people and between cohorts, what the order did, how far the scale can be trusted, and what a
/// reader has to know. What was declared is confirmatory, all else exploratory.
/// @param figures  of the family; nothing where nobody painted them.
std::string familyAsHtml(
    const ReportSection& section, const FamilyResult& family, const FamilyFigures& figures);

}  // namespace study::report
