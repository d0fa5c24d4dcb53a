#pragma once

#include <vector>

#include "study/model/data_table.h"
#include "study/report/report_section.h"
#include "study/report/study_parts.h"

namespace study::report {

/// What was found (conclusionOf()), with the caveat of pooled answers.
Answer answerInWords(const ReportSection& section);

/// The results of a study as tables in words, to be shown in a window, copied or saved: for each
/// family the comparisons of @p profile, each with what it says in words or why it was not tested,
/// and the differences by site; then means, preferences, single items, scores, and what a reader
/// has to know.
/// Tables without rows are left out.
std::vector<DataTable> statisticsTables(const ReportSection& section, Profile profile);

}  // namespace study::report
