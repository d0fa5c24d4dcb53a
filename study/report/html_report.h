#pragma once

#include <string>
#include <vector>

#include "study/report/report_section.h"

namespace study::report {

/// A results section for every study, as one page that needs nothing else: tables in the shape of
/// the punch paper's, figures, what each alternative really felt like, how well it was rendered,
/// and with what it was all made. Text from files and participants is escaped.
std::string asHtml(const std::vector<ReportSection>& sections);

}  // namespace study::report
