#include <algorithm>
#include <optional>

#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

/// The smallest and the largest of some numbers.
struct ValueRange {
  std::optional<double> least;
  std::optional<double> most;

  void add(const std::optional<double>& value) {
    if (!value) return;
    least = std::min(least.value_or(*value), *value);
    most = std::max(most.value_or(*value), *value);
  }
};

/// Arranges what a study has found by Messick's five sources of validity evidence, as Cook and
/// Hatala (2016) describe them for simulators. Also names the sources for which there is no
/// evidence.
class ValidityWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    table(
        say("Validity evidence by Messick’s five sources"),
        {say("Source"), textHeading(say("Evidence"))});
    source("Content", content());
    source("Response process", responseProcess());
    source("Internal structure", internalStructure());
    source("Relations to other variables", relations());
    source("Consequences", consequences());
    endTable();
    note(
        "Face validity is the weakest argument for a simulator. Messick’s five sources of validity "
        "evidence show what this study adds, and what it does not.");
    return std::move(html_);
  }

 private:
  void source(std::string_view name, const std::string& evidence) {
    const auto nothing = say("Nothing in this study.");
    row({say(name), evidence.empty() ? nothing : evidence});
  }

  std::string content() const {
    if (section_.instruments.empty()) return {};
    const auto cited = std::ranges::count_if(
        section_.instruments, [](const auto& one) { return !one.source.citation.empty(); });
    return count(
        section_.instruments.size(),
        "{} questionnaire or form was used; {} with a source, listed under “How this was made”. "
        "Whether experts judged its items is not recorded.",
        "{} questionnaires and forms were used; {} with a source, listed under “How this was "
        "made”. Whether experts judged their items is not recorded.",
        cited);
  }

  std::string responseProcess() const {
    const auto& q = section_.quality;
    if (q.trials == 0) return {};
    return say(
        "The force at the handle was recorded: {} of {} trials passed every check of the "
        "rendering. Time and changes of every answer are in the export.",
        q.pass,
        q.trials);
  }

  std::string internalStructure() const {
    ValueRange alpha;
    for (const auto& family : section_.results.families) {
      for (const auto& part : family.cohorts) {
        for (const auto& method : part.checks.methods) alpha.add(method.alpha.value);
      }
    }
    const auto text = section_.words("Cronbach’s α of the statements about a method: {} to {}.");
    if (!alpha.least) return {};
    return escaped(
        fmt::format(fmt::runtime(text), rounded(alpha.least, 2), rounded(alpha.most, 2)));
  }

  std::string relations() const {
    ValueRange delta;
    for (const auto& family : section_.results.families) {
      for (const auto& between : family.between) {
        delta.add(between.test("mann_whitney").effect.value);
      }
    }
    const auto text = section_.words("Cohorts differ by Cliff’s δ of {} to {} (exploratory).");
    if (!delta.least) return {};
    return escaped(
        fmt::format(fmt::runtime(text), rounded(delta.least, 2), rounded(delta.most, 2)));
  }

  std::string consequences() const {
    const auto text =
        say("Thresholds of acceptability were set for some items; see “Questionnaires”.");
    const bool hasThresholds = std::ranges::any_of(
        section_.results.instruments, [](const auto& one) { return !one.acceptable.empty(); });
    return hasThresholds ? text : std::string();
  }
};

}  // namespace

std::string validityAsHtml(const ReportSection& section) {
  return ValidityWriter(section).all();
}

}  // namespace study::report
