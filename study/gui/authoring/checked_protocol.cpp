#include "study/gui/authoring/checked_protocol.h"

#include <algorithm>

#include "protocols/load_protocol.h"
#include "questionnaires/json/document.h"
#include "study/gui/widgets/desk_language.h"

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

/// "1 warning", "3 warnings", in the language of the desk.
std::string counted(std::size_t count, std::string_view one, std::string_view many) {
  return said(count == 1 ? one : many, count);
}

}  // namespace

int CheckedProtocol::errors() const noexcept {
  return countOf(problems, Severity::Error);
}

int CheckedProtocol::warnings() const noexcept {
  return countOf(problems, Severity::Warning);
}

std::string CheckedProtocol::verdict() const {
  const auto countOf = [](int number) { return static_cast<std::size_t>(number); };
  if (!loaded) {
    return said(
        "Not valid yet: {}.", counted(countOf(std::max(errors(), 1)), "{} error", "{} errors"));
  }
  const auto& protocol = loaded->protocol;
  const auto what = said(
      "\"{}\", {}, {}, {}.",
      protocol.study.title,
      counted(protocol.conditions.size(), "{} condition", "{} conditions"),
      counted(protocol.phases.size(), "{} phase", "{} phases"),
      counted(protocol.cohorts.size(), "{} cohort", "{} cohorts"));
  if (warnings() == 0) return said("Valid: {}", what);
  return said("Valid, {}: {}", counted(countOf(warnings()), "{} warning", "{} warnings"), what);
}

CheckedProtocol checkProtocol(const std::string& source) {
  CheckedProtocol checked{.source = source};
  questionnaires::Problems problems;
  try {
    checked.text = textOf(source);
    checked.loaded = protocols::loadProtocolFile(source, problems);
  } catch (const base::UserError& error) {
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
