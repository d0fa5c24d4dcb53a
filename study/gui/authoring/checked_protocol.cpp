#include "study/gui/authoring/checked_protocol.h"

#include <algorithm>

#include "protocols/load_protocol.h"
#include "protocols/model/library.h"
#include "questionnaires/json/document.h"

namespace study::gui {
namespace {

using questionnaires::Severity;

constexpr std::string_view kProtocolEnding = ".json";
constexpr std::string_view kSchemaEnding = ".schema.json";

int countOf(const std::vector<questionnaires::Problem>& problems, Severity severity) {
  return static_cast<int>(
      std::count_if(problems.begin(), problems.end(), [severity](const auto& problem) {
        return problem.severity == severity;
      }));
}

std::string textOf(const std::string& source) {
  for (const auto& file : protocols::libraryFiles()) {
    if (file.name == source + std::string(kProtocolEnding)) return std::string(file.content);
  }
  return questionnaires::readTextFile(source);
}

std::string counted(std::size_t count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

}  // namespace

int CheckedProtocol::errors() const noexcept {
  return countOf(problems, Severity::Error);
}

int CheckedProtocol::warnings() const noexcept {
  return countOf(problems, Severity::Warning);
}

std::string CheckedProtocol::verdict() const {
  if (!loaded) return "Not valid yet: " + counted(std::max(errors(), 1), "error") + ".";
  const auto& protocol = loaded->protocol;
  return "Valid" + (warnings() > 0 ? ", " + counted(warnings(), "warning") : "") + ": \"" +
         protocol.study.title + "\", " + counted(protocol.conditions.size(), "condition") + ", " +
         counted(protocol.phases.size(), "phase") + ", " +
         counted(protocol.cohorts.size(), "cohort") + ".";
}

CheckedProtocol checkProtocol(const std::string& source) {
  CheckedProtocol checked{.source = source};
  questionnaires::Problems problems;
  try {
    checked.text = textOf(source);
    checked.loaded = protocols::loadProtocolFile(source, problems);
  } catch (const questionnaires::Error& error) {
    problems.add("$", error.what());
  }
  checked.problems = problems.all();
  return checked;
}

std::vector<std::string> shippedProtocols() {
  std::vector<std::string> names;
  for (const auto& file : protocols::libraryFiles()) {
    if (file.name.ends_with(kSchemaEnding) || !file.name.ends_with(kProtocolEnding)) continue;
    names.emplace_back(file.name.substr(0, file.name.size() - kProtocolEnding.size()));
  }
  return names;
}

}  // namespace study::gui
