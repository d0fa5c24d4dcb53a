#pragma once

#include <string>

#include "study/report/report_section.h"

namespace study::report {

/// The reliability of a family's scale, the effect of order, and the notes on its results, each
/// flag once.
/// @param figure  SVG of the ratings by position.
std::string checksAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure);

}  // namespace study::report
