#pragma once

#include <string>

#include "study/report/report_section.h"

namespace study::report {

/// The comparisons within people and between cohorts of one family, as tables, a figure and
/// sentences.
/// @param figure  of the effects.
std::string withinAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure);

/// The differences at each site and pooled over sites; empty if there is only one site.
/// @param figure  the forest plot.
std::string sitesAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure);

}  // namespace study::report
