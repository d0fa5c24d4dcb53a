#include "study/report/family_tests.h"

#include <algorithm>
#include <array>
#include <utility>

#include "analysis/registry/registry.h"
#include "study/report/family_captions.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

/// The heading of a column of p values.
std::string_view headingOf(std::string_view test) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 5> kShort{
      {{"paired_t", "Paired t"},
       {"sign_flip", "Sign flip"},
       {"signed_rank", "Signed rank"},
       {"mixed_model", "Mixed model"},
       {"ordinal_model", "Ordinal model"}}};
  for (const auto& [id, heading] : kShort) {
    if (id == test) return heading;
  }
  return analysis::statisticalTest(test).title;
}

/// Writes one family's tests.
class TestsWriter : HtmlWriter {
 public:
  TestsWriter(const ReportSection& section, const FamilyResult& family)
      : HtmlWriter(section), f_(family) {}

  std::string all(const std::string& effects) {
    put("<h4>{}</h4>", say("Within people"));
    paragraph(
        f_.isDeclared
            ? "The unit is the participant: what one person says about a method is averaged first. "
              "Declared in the protocol, and confirmatory: {}, α = {:g}. All else is exploratory."
            : "The unit is the participant: what one person says about a method is averaged first. "
              "The protocol names {}, α = {:g}, but did not both before the first participant "
              "and ever since: all is exploratory.",
        declaredInWords(f_.family, s_.words),
        f_.family.alpha);
    if (!isAnyTested()) {
      nothingTested();
      return std::move(html_);
    }
    comparisons();
    if (mainFigureOf(s_, f_) == MainFigure::Differences && !effects.empty()) {
      put("<p>{} {}</p>", say("The differences within people:"), reference("answer-figure"));
    } else {
      figure(effects, differencesCaption(f_));
    }
    probabilities();
    sentences();
    between();
    return std::move(html_);
  }

 private:
  static bool isTested(const CohortResult& part) {
    return std::ranges::any_of(part.within.rows, [](const auto& row) {
      return std::ranges::any_of(
          row.tests, [](const auto& test) { return test.isInFamily && test.p; });
    });
  }

  bool isAnyTested() const { return std::ranges::any_of(f_.cohorts, isTested); }

  std::string whyNotTested(const CohortResult& part) const {
    return say(
        "nothing can be tested: {}.", s_.words(part.within.rows.front().test("paired_t").reason));
  }

  /// The reasons why no cohort has a test.
  void nothingTested() {
    for (const auto& part : f_.cohorts) {
      if (part.within.rows.empty() || !hasAnswers(part)) continue;
      put("<p><em>{}</em>: {}</p>", cohort(part.cohort), whyNotTested(part));
    }
  }

  /// p and, if it differs, the adjusted p in brackets; bold if the test is confirmatory and
  /// significant.
  std::string pCell(const analysis::TestRow& test) const {
    auto text = cellOfP(test.p);
    if (!test.p) return text;
    if (test.adjusted && *test.adjusted != *test.p) text += " (" + cellOfP(test.adjusted) + ")";
    const bool isBold = f_.isConfirmatory(test.id) && test.isSignificant.value_or(false);
    return isBold ? "<strong>" + text + "</strong>" : text;
  }

  std::string pairOf(const analysis::WithinComparison& row) const {
    return condition(row.group1) + " vs. " + condition(row.group2);
  }

  void comparisons() {
    table(
        say("Differences of participants’ means"),
        {say("Comparison"),
         say("Difference"),
         say("{:g} % CI", 100.0 * (1.0 - f_.family.alpha)),
         "t",
         "df",
         "g<sub>z</sub>",
         "BF<sub>10</sub>"});
    for (const auto& part : f_.cohorts) {
      if (!hasAnswers(part)) continue;
      if (!isTested(part)) {
        rowOver(cohort(part.cohort) + ": " + whyNotTested(part), 7);
        continue;
      }
      rowOver(
          cohort(part.cohort) + ", " +
              count(part.within.participants, "{} participant", "{} participants"),
          7);
      for (const auto& comparison : part.within.rows) difference(comparison);
    }
    endTable();
    const auto correction = nameOf(f_.family.correction);
    std::vector<std::string> headings{say("Comparison")};
    const auto& pairs = f_.cohorts.front().within.rows;
    for (std::size_t i = 0; !pairs.empty() && i < pairs.front().tests.size(); ++i) {
      const auto& test = pairs.front().tests[i];
      if (!test.isInFamily) continue;
      headings.push_back(say(headingOf(test.id)) + (f_.isNamed(test.id) ? " *" : ""));
    }
    table(
        correction.empty()
            ? say("The same, tested: p without correction")
            : say("The same, tested: p, and in brackets p after {} correction", correction),
        headings);
    for (const auto& part : f_.cohorts) {
      if (!isTested(part)) continue;
      rowOver(cohort(part.cohort), headings.size());
      for (const auto& comparison : part.within.rows) {
        std::vector<std::string> cells{pairOf(comparison)};
        for (const auto& test : comparison.tests) {
          if (test.isInFamily) cells.push_back(pCell(test));
        }
        row(cells);
      }
    }
    endTable();
    if (f_.isNamed("welch")) return;
    note(
        f_.isDeclared ? "* the declared test; bold: adjusted p ≤ α."
                      : "* the test that the protocol names; exploratory");
  }

  void probabilities() {
    const auto& first = f_.cohorts.front().within.probabilities;
    if (first.empty()) return;
    table(
        say("How likely answers of {:g} or more are, by the ordinal mixed model",
            first.front().additional("from").value_or(0.0)),
        {say("Method"),
         say("Answers"),
         say("Observed share"),
         say("Probability"),
         say("{:g} % CI", 100.0 * (1.0 - f_.family.alpha))});
    for (const auto& part : f_.cohorts) {
      if (!isTested(part)) continue;
      rowOver(cohort(part.cohort), 5);
      for (const auto& test : part.within.probabilities) probability(test);
    }
    endTable();
    note(
        "The probability is that of all people for whom the participants stand, with the leniency "
        "and the taste that the model gives them; rounds count equally (exploratory).");
  }

  void probability(const analysis::TestRow& test) {
    if (!test.effect.value) {
      put("<tr><td>{}</td><td class=\"words\" colspan=\"4\">{}</td></tr>",
          condition(test.group1),
          say("not defined: {}", s_.words(test.reason)));
      return;
    }
    row(
        {condition(test.group1),
         std::to_string(test.n1.value_or(0)),
         cellOf(test.statistic.value, 2),
         rounded(test.effect.value, 2),
         cellOf(test.effectInterval)});
  }

  void difference(const analysis::WithinComparison& c) {
    const auto& test = c.test("paired_t");
    if (!test.p) {
      put("<tr><td>{}</td><td>{}</td><td class=\"words\" colspan=\"5\">{}</td></tr>",
          pairOf(c),
          cellOf(test.estimate.value, 2),
          say("not defined: {}", s_.words(test.reason)));
      return;
    }
    const auto& bf10 = c.test("bayes_factor").effect.value;
    row(
        {pairOf(c),
         rounded(test.estimate.value, 2),
         cellOf(test.interval),
         cellOf(test.statistic.value, 2),
         test.df ? fmt::format("{:g}", *test.df) : std::string(),
         effectOf(test),
         bf10 ? escaped(formatBayesFactor(*bf10)) : std::string()});
  }

  /// The effect, with its interval if it has one.
  std::string effectOf(const analysis::TestRow& test) const {
    return cellOf(test.effect.value, 2) +
           (test.effectInterval ? " " + inBrackets(test.effectInterval) : "");
  }

  /// The interval in brackets. In APA style its text has them already.
  std::string inBrackets(const std::optional<analysis::Interval>& interval) const {
    const auto words = cellOf(interval);
    return s_.wording == Wording::Vancouver ? "(" + words + ")" : words;
  }

  void sentences() {
    put("<h4>{}</h4>", say("In sentences"));
    for (const auto& part : f_.cohorts) {
      if (!isTested(part)) continue;
      put("<p><em>{}</em>: ", cohort(part.cohort));
      for (const auto& line : apaLines(part.within, f_.family, s_.words, s_.wording))
        put("{}. ", escaped(line));
      put("</p><ul>");
      for (const auto& comparison : part.within.rows) {
        std::string sentence;
        for (const auto& line : apaLines(comparison, f_.family, s_.words, s_.wording)) {
          sentence += (sentence.empty() ? "" : "; ") + line;
        }
        put("<li>{}: {}.</li>", pairOf(comparison), withSubscripts(escaped(sentence)));
      }
      put("</ul>");
    }
  }

  void between() {
    const auto isTestedPair = [](const BetweenResult& b) {
      return std::ranges::any_of(b.tests, [](const auto& test) { return test.p.has_value(); });
    };
    if (std::ranges::none_of(f_.between, isTestedPair)) return;
    std::vector<std::string> headings{
        say("Method"), "U", say("exact p"), say("Brunner–Munzel p"), say("Cliff’s δ")};
    for (const auto* test : othersOf(f_.between.front())) {
      headings.push_back(say(analysis::statisticalTest(test->id).title) + ", p");
    }
    table(
        say("Between cohorts, on participants’ means (exploratory): positive δ where the first has "
            "the larger values"),
        headings);
    std::string last;
    for (const auto& b : f_.between) {
      if (!isTestedPair(b)) continue;
      const std::string pair = cohort(b.cohort1) + " vs. " + cohort(b.cohort2);
      if (pair != last) rowOver(pair, headings.size());
      last = pair;
      const auto& ranks = b.test("mann_whitney");
      const auto& u = ranks.statistic.value;
      std::vector<std::string> cells{
          condition(b.condition),
          u ? fmt::format("{:g}", *u) : std::string(),
          cellOfP(ranks.p),
          cellOfP(b.test("brunner_munzel").p),
          effectOf(ranks)};
      for (const auto* test : othersOf(b)) cells.push_back(cellOfP(test->p));
      row(cells);
    }
    endTable();
  }

  /// Tests between cohorts that have no column of their own.
  static std::vector<const analysis::TestRow*> othersOf(const BetweenResult& result) {
    std::vector<const analysis::TestRow*> others;
    for (const auto& test : result.tests) {
      if (test.id != "mann_whitney" && test.id != "brunner_munzel") others.push_back(&test);
    }
    return others;
  }

  const FamilyResult& f_;
};

}  // namespace

std::string withinAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure) {
  return TestsWriter(section, family).all(figure);
}

}  // namespace study::report
