#pragma once

#include <string>

#include "study/report/report_section.h"

namespace study::report {

/// Who preferred what, with the figure.
std::string preferencesAsHtml(const ReportSection& section);

/// What the questionnaires that are scored came to; empty where there are none.
std::string instrumentsAsHtml(const ReportSection& section);

/// What each alternative felt like, and how well it was rendered.
std::string renderingAsHtml(const ReportSection& section);

/// What was done, for a methods section; and with what it was computed.
std::string methodsAsHtml(const ReportSection& section);

}  // namespace study::report
