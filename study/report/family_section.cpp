#include "study/report/family_section.h"

#include <algorithm>

#include "study/model/data_table.h"
#include "study/report/family_captions.h"
#include "study/report/family_checks.h"
#include "study/report/family_tests.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/results_text.h"

namespace study::report {
namespace {

/// Writes the answers and the pooled tests.
class FamilyWriter : HtmlWriter {
 public:
  FamilyWriter(
      const ReportSection& section, const FamilyResult& family, const FamilyFigures& figures)
      : HtmlWriter(section), f_(family), figures_(figures) {}

  std::string all() {
    if (std::ranges::none_of(f_.cohorts, hasAnswers)) {
      paragraph("Nobody has answered yet.");
      return std::move(html_);
    }
    means();
    if (isShownByPoint(f_)) {
      figureOrReference(MainFigure::Answers, figures_.answers, kAnswersCaption);
    }
    figureOrReference(MainFigure::People, figures_.people, peopleCaption(f_));
    if (f_.isNamed("welch")) pooled();
    html_ += withinAsHtml(s_, f_, figures_.effects);
    html_ += sitesAsHtml(s_, f_, figures_.sites);
    html_ += checksAsHtml(s_, f_, figures_.positions);
    return std::move(html_);
  }

 private:
  /// The figure; if it is shown beside the answer, a reference to it.
  void figureOrReference(MainFigure kind, const std::string& svg, std::string_view caption) {
    const auto answers = say("The answers:");
    if (mainFigureOf(s_, f_) == kind && !svg.empty()) {
      put("<p>{} {}</p>", answers, reference("answer-figure"));
    } else {
      figure(svg, caption);
    }
  }

  void means() {
    const auto& conditions = f_.cohorts.front().conditions;
    put("<table><caption>{}</caption><thead><tr><th></th>",
        say("Mean M and variance s² of the n answers"));
    for (const auto& c : conditions) put("<th colspan=\"3\">{}</th>", condition(c.name));
    put("</tr><tr><th></th>");
    for (std::size_t i = 0; i < conditions.size(); ++i)
      put("<th>{}</th><th><i>s</i>²</th><th>{}</th>", kM, kN);
    put("</tr></thead><tbody>");
    for (const auto& part : f_.cohorts) {
      if (!hasAnswers(part)) continue;
      std::string cells = "<td>" + cohort(part.cohort) + "</td>";
      for (const auto& c : part.conditions) addMoments(cells, c.answers);
      put("<tr>{}</tr>", cells);
      if (part.sites) meansOfSites(part);
    }
    put("</tbody></table>");
  }

  void meansOfSites(const CohortResult& part) {
    for (const auto& site : part.sites->answers) {
      std::string cells = "<td>" + cohort(part.cohort) + ", " + escaped(site.site) + "</td>";
      for (const auto& answers : site.methods) addMoments(cells, answers);
      put("<tr>{}</tr>", cells);
    }
  }

  static void addMoments(std::string& cells, const analysis::AnswerSample& answers) {
    cells += fmt::format(
        "<td>{}</td><td>{}</td><td>{}</td>",
        cellOf(answers.mean(), 2),
        cellOf(answers.variance(), 2),
        answers.total());
  }

  /// Welch's tests of pooled answers, in the form of the punch paper's table.
  void pooled() {
    const auto isTested = [](const auto& part) {
      return std::ranges::any_of(
          part.comparisons.rows, [](const auto& test) { return test.p.has_value(); });
    };
    if (std::ranges::none_of(f_.cohorts, isTested)) return;
    const auto correction = nameOf(f_.family.correction);
    table(
        correction.empty() ? say("Welch’s t-tests, α = {}", exactly(f_.family.alpha))
                           : say("Welch’s t-tests with {} correction, α = {}",
                                 correction,
                                 exactly(f_.family.alpha)),
        {say("Comparison"),
         say("Difference"),
         say("{:g} % CI", 100.0 * (1.0 - f_.family.alpha)),
         kT,
         kDf,
         kP,
         say("adjusted p")});
    for (const auto& part : f_.cohorts) {
      if (!hasAnswers(part)) continue;
      const auto& perTest = part.comparisons.alphaPerTest;
      rowOver(
          cohort(part.cohort) + (!isTested(part)
                                     ? ": " + notDefined(part.comparisons.rows.front().reason)
                                 : perTest ? say(", α per test {:.4f}", *perTest)
                                           : std::string()));
      if (!isTested(part)) continue;
      for (const auto& test : part.comparisons.rows) pooled(test);
    }
    endTable();
    note(
        f_.isConfirmatory("welch")
            ? "All answers are pooled and taken as independent, as in the punch paper and as the "
              "protocol declares. Bold: adjusted p ≤ α."
            : "All answers are pooled and taken as independent, as in the punch paper "
              "(exploratory).");
  }

  void pooled(const analysis::TestRow& test) {
    const auto pair = condition(test.group1) + " vs. " + condition(test.group2);
    if (!test.p) return row({pair}, notDefined(test.reason));
    const bool isBold = f_.isConfirmatory("welch") && test.isSignificant.value_or(false);
    const auto adjusted = cellOfP(test.adjusted);
    row(
        {pair,
         rounded(test.estimate.value, 2),
         cellOf(test.interval),
         rounded(test.statistic.value, 2),
         rounded(test.df, 2),
         cellOfP(test.p),
         isBold ? "<strong>" + adjusted + "</strong>" : adjusted});
  }

  const FamilyResult& f_;
  const FamilyFigures& figures_;
};

}  // namespace

std::string familyAsHtml(
    const ReportSection& section, const FamilyResult& family, const FamilyFigures& figures) {
  return FamilyWriter(section, family, figures).all();
}

}  // namespace study::report
