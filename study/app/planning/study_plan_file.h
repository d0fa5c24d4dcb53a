#pragma once

#include <string>

#include "study/results/study_plan.h"

namespace study::app {

std::string studyPlanAsJson(const StudyPlan& plan);

}  // namespace study::app
