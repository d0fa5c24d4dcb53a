// Reads instruments and says about each, in a line of JSON, whether it is accepted and what was
// found: for tests that compare our reader with a schema.
#include <iostream>

#include <nlohmann/json.hpp>

#include "questionnaires/document.h"
#include "questionnaires/instrument_file.h"

int main(int argc, char** argv) {
  using namespace questionnaires;
  for (int i = 1; i < argc; ++i) {
    Problems problems;
    const bool isAccepted = readInstrument(readTextFile(argv[i]), problems).has_value();
    nlohmann::json verdict{
        {"file", argv[i]}, {"accepted", isAccepted}, {"problems", nlohmann::json::array()}};
    for (const auto& problem : problems.all()) {
      const bool isError = problem.severity == Severity::Error;
      verdict["problems"].push_back(
          {{"severity", isError ? "error" : "warning"},
           {"path", problem.path},
           {"what", problem.what},
           {"fix", problem.fix}});
    }
    std::cout << verdict << '\n';
  }
}
