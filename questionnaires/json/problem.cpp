#include "questionnaires/json/problem.h"

namespace questionnaires {

void Problems::add(Problem problem) {
  const bool isError = problem.severity == Severity::Error;
  hasErrors_ = hasErrors_ || isError;
  if (list_.size() < kMostProblems) {
    list_.push_back(std::move(problem));
  } else if (list_.size() == kMostProblems) {
    using base::Message;
    list_.push_back(
        {problem.severity,
         "$",
         Message::verbatim("there are more problems"),
         Message::verbatim("fix these first")});
  } else if (isError) {
    list_.back().severity = Severity::Error;
  }
}

std::string describe(const std::vector<Problem>& problems) {
  std::string text;
  for (const auto& problem : problems) {
    text += problem.severity == Severity::Error ? "error   " : "warning ";
    text += problem.path + ": " + base::describe(problem.what);
    if (!problem.fix.empty()) text += "; " + base::describe(problem.fix);
    text += '\n';
  }
  return text;
}

}  // namespace questionnaires
