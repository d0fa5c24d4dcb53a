#pragma once

#include <vector>

#include "study/model/data_table.h"
#include "study/report/study_parts.h"
#include "study/results/study_plan.h"
#include "study/words/words.h"

namespace study::report {

/// How many participants a study of this plan needs and what it can find.
Answer planInWords(const StudyPlan& plan, const words::Words& words = {});

/// A plan as tables in words: power by number of participants and effect, what each cohort can
/// show, the orders, the length of a session, the preferences, and the paragraph for an ethics
/// committee (in English). Tables without rows are left out.
std::vector<DataTable> planTables(const StudyPlan& plan, const words::Words& words = {});

}  // namespace study::report
