#pragma once

#include <string>
#include <vector>

#include "analysis/data/answer_table.h"
#include "analysis/reliability/reliability.h"
#include "analysis/tests/brown_forsythe.h"
#include "analysis/tests/shapiro_wilk.h"

namespace analysis {

/// What a reader may ask about the scores of one method before believing their mean.
struct MethodChecks {
  std::string method;
  ShapiroWilkResult normality;  ///< of the participants' means
  CronbachAlpha alpha;          ///< of the statements about it, averaged over rounds
  OmegaTotal omega;             ///< of the same
};

/// Information, never a switch between tests.
struct ScaleChecks {
  std::vector<MethodChecks> methods;
  BrownForsytheResult spread;  ///< of participants' means, between methods
};

/// Distribution and reliability of one cohort's answers. A participant who left out a statement
/// about a method does not count for that method's reliability.
ScaleChecks scaleChecks(const AnswerTable& table);

}  // namespace analysis
