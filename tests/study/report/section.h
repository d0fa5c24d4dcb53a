#pragma once

#include "study/report/report_section.h"

namespace tests {

/// A report of the punch study as it might be: three conditions, two cohorts, hostile texts, one
/// comparison that is not defined.
study::report::ReportSection madeUpSection();

}  // namespace tests
