#pragma once

#include "study/report/report_section.h"

namespace tests {

/// A report of the punch study with invented results. Every number that a report may print is
/// different, so that exchanged numbers are detected. One comparison, declared as signed-rank test
/// with Holm's correction at alpha = 0.01.
study::report::ReportSection numberedSection();

/// The same for one site of that comparison, and for all sites. Not part of numberedSection().
analysis::SiteAnalysis numberedSites();

}  // namespace tests
