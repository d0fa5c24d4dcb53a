#pragma once

#include <string>
#include <vector>

#include "study/report/report_section.h"

namespace study::report {

/// The results section of every study as one self-contained page: tables in the form of the punch
/// paper's, figures, the force of each alternative, the quality of its rendering, and the methods.
/// Text from files and participants is escaped.
std::string asHtml(const std::vector<ReportSection>& sections);

}  // namespace study::report
