#pragma once

#include "study/report/report_section.h"

namespace tests {

/// A report of the punch study whose results are made up: every number that a report may print is
/// another one, so that a test notices two that are exchanged. One comparison, declared as signed
/// rank test with Holm's correction at alpha = 0.01.
study::report::ReportSection numberedSection();

}  // namespace tests
