#include "tests/support/verdicts.h"

#include <iostream>

#include <nlohmann/json.hpp>

namespace tests {

void printVerdicts(int argc, char** argv, const Reader& isAccepted) {
  for (int i = 1; i < argc; ++i) {
    questionnaires::Problems problems;
    const bool accepted = isAccepted(argv[i], problems);
    nlohmann::json verdict{
        {"file", argv[i]}, {"accepted", accepted}, {"problems", nlohmann::json::array()}};
    for (const auto& problem : problems.all()) {
      const bool isError = problem.severity == questionnaires::Severity::Error;
      verdict["problems"].push_back(
          {{"severity", isError ? "error" : "warning"},
           {"path", problem.path},
           {"what", base::describe(problem.what)},
           {"fix", base::describe(problem.fix)}});
    }
    std::cout << verdict << '\n';
  }
}

}  // namespace tests
