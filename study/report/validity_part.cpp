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

/// Arranges what a study has found by the Standards' five sources of validity evidence, as Cook and
/// Hatala (2016) describe them for simulators. Also names the sources for which there is no
/// evidence.
class ValidityWriter : HtmlWriter {
 public:
  using HtmlWriter::HtmlWriter;

  std::string all() {
    table(
        say("Validity evidence by the five sources of the Standards"),
        {say("Source"), textHeading(say("Evidence"))});
    source("Content", content());
    source("Response process", responseProcess());
    source("Internal structure", internalStructure());
    source("Relations to other variables", relations());
    source("Consequences", consequences());
    endTable();
    note(
        "Face validity is the weakest argument for a simulator. The five sources of validity "
        "evidence show what this study adds, and what it does not.");
    return std::move(html_);
  }

 private:
  void source(std::string_view name, const std::string& evidence) {
    const auto nothing = say("Nothing in this study.");
    row({say(name), evidence.empty() ? nothing : evidence});
  }

  std::string content() const {
    if (section_.instruments.empty() || section_.results.completed() == 0) return {};
    std::size_t all = 0;
    std::size_t own = 0;
    for (const auto& one : section_.instruments) {
      const bool isText = std::ranges::any_of(section_.protocol.phases, [&](const auto& phase) {
        using enum protocols::PhaseType;
        return phase.instrument == one.id &&
               (phase.type == Information || phase.type == Consent || phase.type == Debrief);
      });
      if (isText) continue;
      ++all;
      const auto& source = one.source.citation;
      if (source.empty() || source == kOwnWording || source == kPalpatesWording) ++own;
    }
    return count(
        all,
        "{} questionnaire or form was used, {} of it without a published source (“How this was "
        "made”). Whether experts judged its items is not recorded.",
        "{} questionnaires and forms were used, {} of them without a published source (“How this "
        "was made”). Whether experts judged their items is not recorded.",
        own);
  }

  std::string responseProcess() const {
    const auto& q = section_.quality;
    if (q.trials == 0) return {};
    return say(
        "Quality control only: the force at the handle was recorded, and {} of {} trials passed "
        "every check of the rendering. How participants understood the questions was not "
        "examined.",
        q.pass,
        q.trials);
  }

  std::string internalStructure() const {
    ValueRange alpha;
    ValueRange intervals;
    ValueRange people;
    std::string caution;  ///< on a negative α
    for (const auto& family : section_.results.families) {
      for (const auto& part : family.cohorts) {
        for (const auto& method : part.checks.methods) {
          if (!method.alpha.value) continue;
          alpha.add(method.alpha.value);
          if (!method.alpha.reason.empty()) caution = " " + inWords(method.alpha.reason) + ".";
          people.add(static_cast<double>(method.alpha.respondents));
          if (!method.alpha.interval) continue;
          intervals.add(method.alpha.interval->low);
          intervals.add(method.alpha.interval->high);
        }
      }
    }
    const auto text = section_.words.say(
        "Cronbach’s α of the statements about a method: {} to {}, of {} participants each; "
        "the intervals reach from {} to {}.",
        rounded(alpha.least, 2),
        rounded(alpha.most, 2),
        people.least == people.most
            ? rounded(people.least, 0)
            : section_.words.say("{} to {}", rounded(people.least, 0), rounded(people.most, 0)),
        rounded(intervals.least, 2),
        rounded(intervals.most, 2));
    return alpha.least ? escaped(text) + caution : std::string();
  }

  std::string relations() const {
    ValueRange delta;
    std::size_t all = 0;
    std::size_t clear = 0;
    for (const auto& family : section_.results.families) {
      for (const auto& between : family.between) {
        const auto& test = between.test("mann_whitney");
        if (!test.effect.value) continue;
        delta.add(test.effect.value);
        ++all;
        if (test.p.value_or(1.0) <= family.family.alpha) ++clear;
      }
    }
    const auto text = section_.words.say(
        "Cliff’s δ between cohorts: {} to {} (exploratory); the exact p is significant in {} of {} "
        "comparisons, not corrected for their number.",
        rounded(delta.least, 2),
        rounded(delta.most, 2),
        clear,
        all);
    return all > 0 ? escaped(text) : std::string();
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
