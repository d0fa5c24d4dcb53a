#include <algorithm>

#include "study/model/data_table.h"
#include "study/report/html_writer.h"
#include "study/report/small_samples.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"
#include "study/results/results_text.h"

namespace study::report {
namespace {

/// Writes the answers and the pooled tests.
class FamilyWriter : HtmlWriter {
 public:
  FamilyWriter(
      const ReportSection& section, const FamilyResult& family, const FamilyFigures& figures)
      : HtmlWriter(section), result_(family), figures_(figures) {}

  std::string all() {
    if (std::ranges::none_of(result_.cohorts, hasAnswers)) {
      paragraph("Nobody has answered yet.");
      return std::move(html_);
    }
    if (section_.results.completed() == 1) return {};  // the answer shows all there is
    means();
    if (isShownByPoint(result_)) {
      figureOrReference(MainFigure::Answers, figures_.answers, kAnswersCaption);
    }
    if (result_.isNamed("welch")) putPooledTests();
    figureOrReference(
        MainFigure::ParticipantMeans, figures_.participantMeans, kParticipantMeansCaption);
    html_ += withinAsHtml(section_, result_, figures_.effects);
    html_ += sitesAsHtml(section_, result_, figures_.sites);
    checks();
    const auto leftOut = leftOutInWords(result_, section_.words);
    if (!leftOut.empty()) put("<p>{}</p>", escaped(withCurlyQuotes(leftOut)));
    return std::move(html_);
  }

 private:
  /// The figure; if it is shown beside the answer, a reference to it.
  void figureOrReference(MainFigure kind, const std::string& svg, std::string_view caption) {
    const auto answers = say("The answers:");
    if (mainFigureOf(section_, result_) == kind && !svg.empty()) {
      put("<p class=\"note\">{} {}.</p>", answers, reference("answer-figure"));
    } else {
      figure(svg, caption);
    }
  }

  void means() {
    const auto& conditions = result_.cohorts.front().conditions;
    std::vector<std::pair<std::string, std::vector<analysis::AnswerSample>>> rows;
    for (const auto& part : result_.cohorts) {
      if (!hasAnswers(part)) continue;
      rows.emplace_back(cohort(part.cohort), std::vector<analysis::AnswerSample>());
      for (const auto& c : part.conditions) rows.back().second.push_back(c.answers);
      if (!part.sites) continue;
      for (const auto& site : part.sites->answers) {
        rows.emplace_back(cohort(part.cohort) + ", " + escaped(site.site), site.methods);
      }
    }
    const bool isEachOfSameSize = std::ranges::all_of(rows, [](const auto& row) {
      return std::ranges::all_of(row.second, [&](const auto& answers) {
        return answers.total() == row.second.front().total();
      });
    });
    put("<table><caption>{}</caption><thead><tr><th></th>{}",
        withScale(say("Mean M and variance s² of the n answers"), result_.family),
        isEachOfSameSize ? "<th></th>" : "");
    for (const auto& c : conditions) {
      put("<th colspan=\"{}\">{}</th>", isEachOfSameSize ? 2 : 3, condition(c.name));
    }
    const auto n = fmt::format("<th>{}</th>", kN);
    put("</tr><tr><th></th>{}", isEachOfSameSize ? n : std::string());
    for (std::size_t i = 0; i < conditions.size(); ++i) {
      put("<th>{}</th><th><i>s</i>²</th>{}", kM, isEachOfSameSize ? std::string() : n);
    }
    put("</tr></thead><tbody>");
    for (const auto& [title, samples] : rows) {
      std::string cells = "<td>" + title + "</td>";
      const auto size = [&](const auto& answers) {
        cells += fmt::format("<td>{}</td>", answers.total());
      };
      if (isEachOfSameSize) size(samples.front());
      for (const auto& answers : samples) {
        cells += "<td>" + cellOf(answers.mean(), 2) + "</td><td>" + cellOf(answers.variance(), 2) +
                 "</td>";
        if (!isEachOfSameSize) size(answers);
      }
      put("<tr>{}</tr>", cells);
    }
    put("</tbody></table>");
  }

  /// Welch's tests of pooled answers, in the form of the punch paper's table.
  void putPooledTests() {
    const auto isTested = [](const auto& part) {
      return std::ranges::any_of(
          part.comparisons.rows, [](const auto& test) { return test.p.has_value(); });
    };
    if (std::ranges::none_of(result_.cohorts, isTested)) return;
    const auto correction = nameOf(result_.family.correction);
    table(
        correction.empty() ? say("Welch’s t-tests, α = {}", exactDecimal(result_.family.alpha))
                           : say("Welch’s t-tests with {} correction, α = {}",
                                 correction,
                                 exactDecimal(result_.family.alpha)),
        {say("Comparison"),
         say("Difference"),
         say("{:g} % CI", 100.0 * (1.0 - result_.family.alpha)),
         kT,
         kDf,
         kP,
         correction.empty() ? kP : withSubscripts(fmt::format("p_{}", correction))});
    for (const auto& part : result_.cohorts) {
      if (!hasAnswers(part)) continue;
      const auto& perTest = part.comparisons.alphaPerTest;
      rowOver(
          cohort(part.cohort) + (!isTested(part)
                                     ? ": " + notDefined(part.comparisons.rows.front().reason)
                                 : perTest ? say(", α per test {:.4f}", *perTest)
                                           : std::string()));
      if (!isTested(part)) continue;
      for (const auto& test : part.comparisons.rows) putPooledTest(test);
    }
    endTable();
    note(
        result_.isConfirmatory("welch")
            ? "All answers are pooled and taken as independent, as in the punch paper and as the "
              "protocol declares. Bold: p ≤ α after correction."
            : "All answers are pooled and taken as independent, as in the punch paper "
              "(exploratory).");
  }

  void putPooledTest(const analysis::TestRow& test) {
    const auto pair = condition(test.group1) + " vs. " + condition(test.group2);
    if (!test.p) return row({pair}, notDefined(test.reason));
    const bool isBold = result_.isConfirmatory("welch") && test.isSignificant.value_or(false);
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

  /// The effect of order, and the reliability of the scale.
  void checks() {
    if (std::ranges::any_of(result_.cohorts, hasSlope)) {
      put("<h4>{}</h4>", say("The order"));
      paragraph(
          "Exploratory: the slope of each person’s answers over the positions, and a one-sample "
          "t-test of these slopes.");
      putOrderEffect();
    }
    if (std::ranges::any_of(result_.cohorts, hasChecks)) {
      put("<h4>{}</h4>", say("The scale"));
      putReliability();
    }
  }

  static bool hasSlope(const CohortResult& part) { return part.position.slope.p.has_value(); }

  static bool isChecked(const analysis::MethodChecks& method) {
    return method.alpha.value || method.omega.value;
  }
  static bool hasChecks(const CohortResult& part) {
    return std::ranges::any_of(part.checks.methods, isChecked);
  }

  void putOrderEffect() {
    put("<ul>");
    for (const auto& part : result_.cohorts) {
      if (!hasAnswers(part)) continue;
      const auto& slope = part.position.slope;
      if (!slope.p) {
        put("<li>{}: {}</li>",
            cohort(part.cohort),
            say("no slope over positions: {}.", section_.inWords(slope.reason)));
        continue;
      }
      put("<li>{}: {}</li>",
          cohort(part.cohort),
          say("{} from one position to the next, 95 % CI {}, t({:g}) = {}, p {}.",
              withUnit(section_, result_.family, rounded(slope.meanDifference, 2)),
              formatInterval(part.position.slopeInterval, section_.wording, section_.words),
              slope.degreesOfFreedom.value_or(0.0),
              rounded(slope.t, 2),
              equalsOfP(slope.p)));
    }
    put("</ul>");
  }

  void putReliability() {
    bool isAnyImproper = false;
    base::Message onAlpha;  ///< what a negative α says
    table(
        say("Reliability of the statements"),
        {say("Method"),
         say("Statements"),
         say("Cronbach’s α"),
         say("95 % CI"),
         say("McDonald’s ω")});
    for (const auto& part : result_.cohorts) {
      if (!hasChecks(part)) continue;
      rowOver(cohort(part.cohort));
      for (const auto& method : part.checks.methods) {
        if (!isChecked(method)) continue;
        isAnyImproper = isAnyImproper || method.omega.isImproper;
        const bool isDoubtful = method.alpha.value && !method.alpha.reason.empty();
        if (isDoubtful) onAlpha = method.alpha.reason;
        row(
            {condition(method.method),
             std::to_string(method.alpha.items),
             cellOf(method.alpha.value, 2) + (isDoubtful ? " ‡" : ""),
             cellOf(method.alpha.interval),
             cellOf(method.omega.value, 2) + (method.omega.isImproper ? " †" : "")});
      }
    }
    endTable();
    const auto agree = say("α and ω: whether the statements about a method agree.");
    const auto improper = say("†: the factor of this ω explains a statement completely.");
    put("<p class=\"note\">{}{}{}</p>",
        agree,
        isAnyImproper ? " " + improper : std::string(),
        onAlpha.empty() ? std::string() : " ‡: " + inWords(onAlpha) + ".");
  }

  const FamilyResult& result_;
  const FamilyFigures& figures_;
};

}  // namespace

std::string familyAsHtml(
    const ReportSection& section, const FamilyResult& family, const FamilyFigures& figures) {
  return FamilyWriter(section, family, figures).all();
}

}  // namespace study::report
