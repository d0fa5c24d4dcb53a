#pragma once

#include "study/report/report_section.h"

namespace tests {

/// A report of the punch study: three conditions, two cohorts, texts that need escaping, one
/// comparison that is not defined.
study::report::ReportSection madeUpSection();

/// The same with participants of two sites, by turns, and one of a third.
study::report::ReportSection madeUpSectionOfSites();

}  // namespace tests
