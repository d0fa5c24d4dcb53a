#include <algorithm>
#include <array>
#include <set>
#include <utility>

#include "analysis/effects/bayes_factor.h"
#include "analysis/registry/registry.h"
#include "study/model/data_table.h"
#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

/// The number of participants with answers about one of @p methods; without any, about any method.
std::size_t respondentsIn(
    const analysis::AnswerTable& table, const std::vector<std::string>& methods = {}) {
  std::set<std::size_t> people;
  for (const auto& answer : table.answers) {
    const bool isMeant =
        methods.empty() || std::ranges::count(methods, table.methods[answer.method]) > 0;
    if (isMeant) people.insert(answer.participant);
  }
  return people.size();
}

/// Writes one family's tests.
class TestsWriter : HtmlWriter {
 public:
  TestsWriter(const ReportSection& section, const FamilyResult& family)
      : HtmlWriter(section), result_(family) {}

  std::string all(const std::string& effects) {
    put("<h4>{}</h4>", say("Within people"));
    paragraph(
        result_.isDeclared
            ? "The unit is the participant: what one person says about a method is averaged first. "
              "Declared in the protocol, and confirmatory: {}, α = {:g}. All else is exploratory."
            : "The unit is the participant: what one person says about a method is averaged first. "
              "The protocol names {}, α = {:g}, but did not both before the first participant "
              "and ever since: all is exploratory.",
        declaredInWords(result_.family, section_.words),
        result_.family.alpha);
    if (!isAnyTested()) {
      putReasonsNotTested();
      return std::move(html_);
    }
    overall();
    differences();
    tests();
    if (mainFigureOf(section_, result_) != MainFigure::Differences)
      putFigure(effects, escaped(differencesCaption(result_, section_.words)));
    putTestsBetweenCohorts();
    return std::move(html_);
  }

 private:
  static bool isTested(const CohortResult& part) {
    return std::ranges::any_of(part.within.rows, [](const auto& row) {
      return std::ranges::any_of(
          row.tests, [](const auto& test) { return test.isInFamily && test.p; });
    });
  }

  bool isAnyTested() const { return std::ranges::any_of(result_.cohorts, isTested); }

  std::string whyNotTested(const CohortResult& part) const {
    return say(
        "nothing can be tested: {}.",
        section_.inWords(part.within.rows.front().test("paired_t").reason));
  }

  /// The reasons why no cohort has a test.
  void putReasonsNotTested() {
    for (const auto& part : result_.cohorts) {
      if (part.within.rows.empty() || !hasAnswers(part)) continue;
      put("<p><em>{}</em>: {}</p>", cohort(part.cohort), whyNotTested(part));
    }
  }

  /// p and, if it differs, the adjusted p in brackets; bold if the test is confirmatory and
  /// significant.
  std::string pCell(const analysis::TestRow& test) {
    auto text = cellOfP(test.p);
    if (!test.p) return text;
    const bool isCorrected = !nameOf(result_.family.correction).empty();
    if (test.adjusted && isCorrected) text += " (" + cellOfP(test.adjusted) + ")";
    const bool isBold = result_.isConfirmatory(test.id) && test.isSignificant.value_or(false);
    hasBold_ = hasBold_ || isBold;
    return isBold ? "<strong>" + text + "</strong>" : text;
  }

  std::string pairOf(const analysis::WithinComparison& row) const {
    return condition(row.group1) + " vs. " + condition(row.group2);
  }

  /// The tests of all methods together, above the tables of pairs.
  void overall() {
    for (const auto& part : result_.cohorts) {
      if (!isTested(part)) continue;
      auto lines = apaLines(part.within, result_.family, section_.words, section_.wording);
      lines.resize(part.within.overall.size());  // the models' variances follow
      std::string sentences;
      for (const auto& line : lines) {
        sentences += " " + escaped(line) + ".";
      }
      const auto leftOut = respondentsIn(part.table) - part.within.participants;
      const auto who =
          say("{} of {} participants judged all methods; the others are left out.",
              part.within.participants,
              part.within.participants + leftOut);
      put("<p><em>{}</em>:{}{}</p>",
          cohort(part.cohort),
          sentences,
          leftOut > 0 && !sentences.empty() ? " " + who : std::string());
    }
  }

  /// The numbers that are not in the table on page 1. That table has the differences, unless pooled
  /// tests are declared.
  void differences() {
    const bool areDifferencesShown = !result_.isNamed("welch");
    const auto ci = say("{:g} % CI", 100.0 * (1.0 - result_.family.alpha));
    table(
        say("Differences of participants’ means"),
        {say("Comparison"),
         say("Difference"),
         ci,
         kT,
         kDf,
         "<i>g</i><sub>z</sub>",
         ci,
         "BF<sub>10</sub>",
         say("Odds ratio"),
         ci});
    for (const auto& part : result_.cohorts) {
      if (!hasAnswers(part)) continue;
      if (!isTested(part)) {
        rowOver(cohort(part.cohort) + ": " + whyNotTested(part));
        continue;
      }
      rowOver(cohort(part.cohort) + ", " + peopleIn(part));
      for (const auto& comparison : part.within.rows) difference(comparison, areDifferencesShown);
    }
    endTable();
    const auto bayes = say(
        "BF: Bayes factor of a difference against none, of which the prior is Cauchy’s with scale "
        "{:.3f}.",
        analysis::kMediumPriorScale);
    const auto odds = say("Odds ratio: of higher answers, by the ordinal mixed model.");
    std::string note;
    const auto add = [&](bool isTrue, const std::string& sentence) {
      if (isTrue) note += (note.empty() ? "" : " ") + sentence;
    };
    add(areDifferencesShown, withReferences("The differences are in {}.", {"answer"}));
    add(hasBayesFactor_, bayes);
    add(hasOdds_, odds);
    if (!note.empty()) put("<p class=\"note\">{}</p>", note);
  }

  /// "9 participants", or "8 to 10 participants" where not all were compared in each comparison.
  std::string peopleIn(const CohortResult& part) const {
    std::set<std::size_t> counts;
    for (const auto& row : part.within.rows) {
      const auto& test = row.test("paired_t");
      if (test.p) counts.insert(test.n1.value_or(0));
    }
    if (counts.empty()) counts.insert(part.within.participants);
    const auto range = say("{} to {} participants", *counts.begin(), *counts.rbegin());
    const auto same = count(*counts.begin(), "{} participant", "{} participants");
    return counts.size() > 1 ? range : same;
  }

  void tests() {
    const auto correction = nameOf(result_.family.correction);
    bool hasW = false;
    std::vector<std::string> headings{say("Comparison")};
    const auto& pairs = result_.cohorts.front().within.rows;
    for (std::size_t i = 0; !pairs.empty() && i < pairs.front().tests.size(); ++i) {
      const auto& test = pairs.front().tests[i];
      if (!test.isInFamily) continue;
      headings.push_back(say(shortNameOf(test.id)) + (result_.isNamed(test.id) ? " *" : ""));
    }
    headings.push_back(say("Equivalence"));
    headings.push_back(say("Shapiro–Wilk") + " " + kW);
    table(
        correction.empty()
            ? say("Tests of these differences: p without correction")
            : say("Tests of these differences: p, and in brackets p after {} correction",
                  correction),
        headings);
    for (const auto& part : result_.cohorts) {
      if (!isTested(part)) continue;
      rowOver(cohort(part.cohort));
      for (const auto& comparison : part.within.rows) {
        std::vector<std::string> cells{pairOf(comparison)};
        for (const auto& test : comparison.tests) {
          if (test.isInFamily) cells.push_back(pCell(test));
        }
        const auto* tost = analysis::findTest(comparison.tests, "tost");
        cells.push_back(tost == nullptr ? std::string() : cellOfP(tost->p));
        const auto normality = normalityOf(part, comparison);
        hasW = hasW || normality.w;
        cells.push_back(
            normality.p ? rounded(normality.w, 2) + " (" + cellOfP(normality.p) + ")" : "");
        row(cells);
      }
    }
    endTable();
    std::string text;
    const auto add = [&](bool isTrue, const std::string& sentence) {
      if (isTrue) text += (text.empty() ? "" : " ") + sentence;
    };
    const auto bound = result_.family.equivalenceBound;
    const auto within =
        say("Equivalence: two one-sided tests within ±{:g}; their p is not corrected.",
            bound.value_or(0.0));
    const auto marked =
        say(!result_.isDeclared ? "* the test that the protocol names; exploratory."
            : hasBold_          ? "* the declared test; bold: its adjusted p ≤ α."
                                : "* the declared test; none of its adjusted p is ≤ α.");
    const auto normality = say(
        "Shapiro–Wilk W: of the differences, with p in brackets. The paired t-test takes them as "
        "normal; no test is chosen by W.");
    const auto declared = say("Where tests disagree, the declared one decides.");
    const auto others =
        say("Of the other tests, the exact ones (sign flip, signed rank) assume least, and the "
            "models of single answers most.");
    add(result_.isDeclared, declared);
    add(true, others);
    add(bound.has_value(), within);
    add(!result_.isNamed("welch"), marked);
    add(hasW, normality);
    if (!text.empty()) put("<p class=\"note\">{}</p>", text);
  }

  void difference(const analysis::WithinComparison& c, bool areDifferencesShown) {
    const auto& test = c.test("paired_t");
    if (!test.p) return row({pairOf(c)}, notDefined(test.reason));
    const auto* ordinal = analysis::findTest(c.tests, "ordinal_model");
    const bool hasOdds = ordinal != nullptr && ordinal->p;
    hasOdds_ = hasOdds_ || hasOdds;
    hasBayesFactor_ = hasBayesFactor_ || c.test("bayes_factor").effect.value.has_value();
    row(
        {pairOf(c),
         areDifferencesShown ? std::string() : rounded(test.estimate.value, 2),
         areDifferencesShown ? std::string() : cellOf(test.interval),
         cellOf(test.statistic.value, 2),
         test.df ? fmt::format("{:g}", *test.df) : std::string(),
         cellOf(test.effect.value, 2),
         cellOf(test.effectInterval),
         bayesFactorOf(c),
         hasOdds ? cellOf(ordinal->effect.value, 2) : std::string(),
         hasOdds ? cellOf(ordinal->effectInterval) : std::string()});
  }

  /// With two decimals, so that points are below each other; none from 100 on.
  std::string bayesFactorOf(const analysis::WithinComparison& c) const {
    const auto& bf10 = c.test("bayes_factor").effect.value;
    if (!bf10) return {};
    const bool isWithin = *bf10 >= 0.005 && *bf10 <= 1000.0;
    return isWithin ? rounded(bf10, *bf10 < 100.0 ? 2 : 0)
                    : escaped(*bf10 < 1.0 ? "< 0.01" : "> 1000");
  }

  void putTestsBetweenCohorts() {
    const auto isTestedPair = [](const BetweenResult& b) {
      return std::ranges::any_of(b.tests, [](const auto& test) { return test.p.has_value(); });
    };
    if (std::ranges::none_of(result_.between, isTestedPair)) return;
    std::vector<std::string> headings{
        say("Method"),
        "<i>U</i>",
        say("exact p"),
        say("Brunner–Munzel p"),
        say("Cliff’s δ"),
        say("95 % CI")};
    for (const auto* test : otherTestsOf(result_.between.front())) {
      headings.push_back(say(analysis::statisticalTest(test->id).title) + ", p");
    }
    table(
        say("Between cohorts, on participants’ means (exploratory): positive δ where the first has "
            "the larger values"),
        headings);
    std::string last;
    bool isAnyApart = false;  // an interval of δ and the exact p
    for (const auto& b : result_.between) {
      if (!isTestedPair(b)) continue;
      const std::string pair = cohort(b.cohort1) + " vs. " + cohort(b.cohort2);
      if (pair != last) rowOver(pair);
      last = pair;
      const auto& ranks = b.test("mann_whitney");
      const auto& u = ranks.statistic.value;
      std::vector<std::string> cells{
          condition(b.condition),
          cellOf(u, 1),
          cellOfP(ranks.p),
          cellOfP(b.test("brunner_munzel").p),
          cellOf(ranks.effect.value, 2),
          cellOf(ranks.effectInterval)};
      for (const auto* test : otherTestsOf(b)) cells.push_back(cellOfP(test->p));
      row(cells);
      const auto& interval = ranks.effectInterval;
      isAnyApart = isAnyApart || (interval && interval->low * interval->high > 0.0 &&
                                  ranks.p.value_or(0.0) > result_.family.alpha);
    }
    endTable();
    if (isAnyApart) {
      note(
          "Intervals of δ are approximate: one may leave out 0 where the exact p is above {}. "
          "Neither is corrected for the number of comparisons.",
          exactDecimal(result_.family.alpha));
    }
  }

  /// Tests between cohorts that have no column of their own.
  static std::vector<const analysis::TestRow*> otherTestsOf(const BetweenResult& result) {
    std::vector<const analysis::TestRow*> others;
    for (const auto& test : result.tests) {
      if (test.id != "mann_whitney" && test.id != "brunner_munzel") others.push_back(&test);
    }
    return others;
  }

  const FamilyResult& result_;
  bool hasBold_ = false;         ///< whether a confirmatory test is significant
  bool hasOdds_ = false;         ///< whether any odds ratio is shown
  bool hasBayesFactor_ = false;  ///< the same of Bayes factors
};

}  // namespace

std::vector<Declared> declaredIn(const FamilyResult& family, const CohortResult& cohort) {
  std::vector<Declared> all;
  const auto equivalenceP = [](const analysis::WithinComparison& row) {
    const auto* tost = analysis::findTest(row.tests, "tost");
    return tost == nullptr ? std::nullopt : tost->p;
  };
  static const analysis::TestRow kNone;
  if (family.isNamed("welch")) {
    for (const auto& row : cohort.comparisons.rows) {
      const auto within = std::ranges::find_if(cohort.within.rows, [&](const auto& other) {
        return other.group1 == row.group1 && other.group2 == row.group2;
      });
      const bool isWithin = within != cohort.within.rows.end();
      all.push_back(
          {row.group1,
           row.group2,
           &row,
           &row,
           isWithin ? &within->test("paired_t") : &kNone,
           respondentsIn(cohort.table, {row.group1, row.group2}),
           isWithin ? equivalenceP(*within) : std::nullopt});
    }
    return all;
  }
  for (const auto& row : cohort.within.rows) {
    const auto& paired = row.test("paired_t");
    all.push_back(
        {row.group1,
         row.group2,
         &paired,
         &row.test(idOf(family.family.test)),
         &paired,
         paired.n1.value_or(0),
         equivalenceP(row)});
  }
  return all;
}

std::vector<Declared> leftOutIn(const FamilyResult& family, const CohortResult& cohort) {
  auto rows = declaredIn(family, cohort);
  if (std::ranges::none_of(rows, &Declared::isDefined)) return {};
  std::erase_if(rows, [](const auto& row) { return row.isDefined(); });
  return rows;
}

std::pair<std::size_t, std::size_t> peopleComparedIn(
    const FamilyResult& family, const CohortResult& cohort) {
  std::set<std::size_t> counts;
  for (const auto& row : declaredIn(family, cohort)) {
    if (row.isDefined()) counts.insert(row.people);
  }
  if (counts.empty()) counts.insert(respondentsIn(cohort.table));
  return {*counts.begin(), *counts.rbegin()};
}

std::string withinAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure) {
  return TestsWriter(section, family).all(figure);
}

std::string_view shortNameOf(std::string_view test) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 12> kShort{
      {{"paired_t", "Paired t"},
       {"sign_flip", "Sign flip"},
       {"signed_rank", "Signed rank"},
       {"mixed_model", "Mixed model"},
       {"ordinal_model", "Ordinal model"},
       {"welch", "Welch’s t"},
       {"tost", "Equivalence"},
       {"bayes_factor", "Bayes factor"},
       {"friedman", "Friedman"},
       {"rm_anova", "Repeated-measures ANOVA"},
       {"mann_whitney", "Mann–Whitney"},
       {"brunner_munzel", "Brunner–Munzel"}}};
  for (const auto& [id, name] : kShort) {
    if (id == test) return name;
  }
  return analysis::statisticalTest(test).title;
}

}  // namespace study::report
