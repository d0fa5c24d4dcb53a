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
    if (!f_.isNamed("welch")) pooled();
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
        say("Mean μ and variance σ² of the answers (n answers)"));
    for (const auto& c : conditions) put("<th colspan=\"3\">{}</th>", condition(c.name));
    put("</tr><tr><th></th>");
    for (std::size_t i = 0; i < conditions.size(); ++i) put("<th>μ</th><th>σ²</th><th>n</th>");
    put("</tr></thead><tbody>");
    for (const auto& part : f_.cohorts) {
      if (!hasAnswers(part)) continue;
      std::vector<std::string> cells{cohort(part.cohort)};
      for (const auto& c : part.conditions) addMoments(cells, c.answers);
      row(cells);
      if (part.sites) meansOfSites(part);
    }
    endTable();
  }

  void meansOfSites(const CohortResult& part) {
    for (const auto& site : part.sites->answers) {
      std::vector<std::string> cells{cohort(part.cohort) + ", " + escaped(site.site)};
      for (const auto& answers : site.methods) addMoments(cells, answers);
      row(cells);
    }
  }

  static void addMoments(std::vector<std::string>& cells, const analysis::AnswerSample& answers) {
    cells.push_back(cellOf(answers.mean(), 2));
    cells.push_back(cellOf(answers.variance(), 2));
    cells.push_back(std::to_string(answers.total()));
  }

  /// Welch's tests of pooled answers, in the form of the punch paper's table.
  void pooled() {
    const auto isTested = [](const auto& part) {
      return std::ranges::any_of(
          part.comparisons.rows, [](const auto& test) { return test.p.has_value(); });
    };
    if (std::ranges::none_of(f_.cohorts, isTested)) return;
    const bool isNamed = f_.isNamed("welch");
    const auto correction =
        nameOf(isNamed ? f_.family.correction : protocols::CorrectionType::Bonferroni);
    table(
        correction.empty() ? say("Welch’s t-tests, α = {}", exactly(f_.family.alpha))
                           : say("Welch’s t-tests with {} correction, α = {}",
                                 correction,
                                 exactly(f_.family.alpha)),
        {say("Comparison"),
         say("Difference"),
         say("{:g} % CI", 100.0 * (1.0 - f_.family.alpha)),
         "t",
         "df",
         "p",
         say("adjusted p")});
    for (const auto& part : f_.cohorts) {
      if (!hasAnswers(part)) continue;
      if (!isTested(part)) {
        rowOver(
            cohort(part.cohort) + ": " +
                say("not defined: {}", s_.words(part.comparisons.rows.front().reason)),
            7);
        continue;
      }
      const auto& perTest = part.comparisons.alphaPerTest;
      rowOver(
          cohort(part.cohort) + (perTest ? say(", α per test {:.4f}", *perTest) : std::string()),
          7);
      for (const auto& test : part.comparisons.rows) pooled(test);
    }
    endTable();
    note(
        "Profile as-published ({}): answers of all statements and rounds are pooled per "
        "participant "
        "and method and treated as independent, as in the punch paper. "
        "Several answers of one person are not independent, so these p values may be too small or "
        "too large.",
        s_.words(
            f_.isConfirmatory("welch") ? "declared in the protocol: confirmatory" : "exploratory"));
    if (f_.isConfirmatory("welch")) note("Bold: adjusted p ≤ α.");
  }

  void pooled(const analysis::TestRow& test) {
    put("<tr{}><td>{} vs. {}</td>",
        f_.isConfirmatory("welch") && test.isSignificant.value_or(false) ? " class=\"yes\"" : "",
        condition(test.group1),
        condition(test.group2));
    if (!test.p) {
      put("<td class=\"words\" colspan=\"6\">{}</td></tr>",
          say("not defined: {}", s_.words(test.reason)));
      return;
    }
    put("<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
        rounded(test.estimate.value, 2),
        cellOf(test.interval),
        rounded(test.statistic.value, 2),
        rounded(test.df, 2),
        cellOfP(test.p),
        cellOfP(test.adjusted));
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
