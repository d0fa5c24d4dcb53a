#pragma once

#include <string>
#include <vector>

#include "analysis/data/factor.h"

namespace tests {

/// The scores of one cohort of the synthetic study in tests/data/stats/study, and what they
/// belong to.
struct StudyAnswers {
  std::vector<double> scores;
  analysis::Factor participant;
  analysis::Factor method;  ///< interpolation, fem, kalman
  analysis::Factor round;

  std::vector<int> levels() const { return {scores.begin(), scores.end()}; }
};

/// @param cohort  professional or non-professional.
StudyAnswers studyAnswers(const std::string& cohort);

}  // namespace tests
