#pragma once

#include <string>

#include "study/report/report_section.h"

namespace study::report {

/// How far a family's scale and order can be trusted, and what a reader has to know about its
/// results, each flag once.
/// @param figure  of the positions.
std::string checksAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure);

}  // namespace study::report
