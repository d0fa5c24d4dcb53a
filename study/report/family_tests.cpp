#include "study/report/family_tests.h"

#include <algorithm>

#include "study/report/html_writer.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

using protocols::TestType;

/// p and, where it is another, adjusted p in brackets; bold where it is the named test's and
/// significant.
std::string pCell(const analysis::AdjustedP& p, bool isNamed) {
  std::string text = escaped(pInWords(p.p));
  if (p.p && p.adjusted && *p.adjusted != *p.p) {
    text += " (" + escaped(pInWords(p.adjusted)) + ")";
  }
  return isNamed && p.isSignificant.value_or(false) ? "<strong>" + text + "</strong>" : text;
}

/// "p_Holm" and its like as print has them.
std::string withSubscripts(std::string html) {
  const auto lower = [&](std::string_view before, std::string_view plain) {
    std::string::size_type at = 0;
    while ((at = html.find(plain, at)) != std::string::npos) {
      const auto begin = at + before.size();
      const auto skipped = html[begin] == '_' ? begin + 1 : begin;
      const auto end = std::min(html.find(' ', begin), html.size());
      const std::string sub = "<sub>" + html.substr(skipped, end - skipped) + "</sub>";
      html.replace(begin, end - begin, sub);
      at = begin + sub.size();
    }
  };
  lower("p", "p_");
  lower("g", "g_z");
  lower("BF", "BF10");
  return html;
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
    comparisons();
    const bool isCorrected = !nameOf(f_.family.correction).empty();
    figure(
        effects,
        isCorrected
            ? "Mean differences within people: the thick line is the interval at 1 − α, the thin "
              "one "
              "at 1 − α/m, as wide as Bonferroni’s correction asks of m comparisons. Shaded, where "
              "the protocol declares it, are differences that count as none."
            : "Mean differences within people with their intervals at 1 − α. Shaded, where the "
              "protocol declares it, are differences that count as none.");
    sentences();
    between();
    return std::move(html_);
  }

 private:
  /// Whether the protocol names @p test, declared before there were data or not.
  bool isNamed(TestType test) const { return f_.family.test == test; }
  std::string marked(std::string_view english, TestType test) const {
    return say(english) + (isNamed(test) ? " *" : "");
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
      rowOver(
          cohort(part.cohort) + ", " +
              count(part.within.participants, "{} participant", "{} participants"),
          7);
      for (const auto& comparison : part.within.rows) difference(comparison);
    }
    endTable();
    const auto correction = nameOf(f_.family.correction);
    table(
        correction.empty()
            ? say("The same, tested: p without correction")
            : say("The same, tested: p, and in brackets p after {} correction", correction),
        {say("Comparison"),
         marked("Paired t", TestType::PairedT),
         marked("Sign flip", TestType::SignFlip),
         marked("Signed rank", TestType::SignedRank),
         say("Mixed model"),
         say("Ordinal model")});
    for (const auto& part : f_.cohorts) {
      rowOver(cohort(part.cohort), 6);
      for (const auto& c : part.within.rows) {
        row(
            {pairOf(c),
             pCell(c.pairedP, isNamed(TestType::PairedT)),
             pCell(c.signFlipP, isNamed(TestType::SignFlip)),
             pCell(c.signedRankP, isNamed(TestType::SignedRank)),
             pCell(c.mixedP, false),
             pCell(c.ordinalP, false)});
      }
    }
    endTable();
    if (isNamed(TestType::Welch)) return;
    note(
        f_.isDeclared ? "* the declared test; bold: adjusted p ≤ α."
                      : "* the test that the protocol names, exploratory; bold: adjusted p ≤ α.");
  }

  void difference(const analysis::WithinComparison& c) {
    if (!c.paired.meanDifference) {
      put("<tr><td>{}</td><td class=\"words\" colspan=\"6\">{}</td></tr>",
          pairOf(c),
          say("not defined: {}", s_.words(c.paired.reason)));
      return;
    }
    const auto& g = c.effects.hedgesGz;
    row(
        {pairOf(c),
         rounded(c.paired.meanDifference, 2),
         intervalInWords(c.interval),
         rounded(c.paired.t, 2),
         c.paired.degreesOfFreedom ? fmt::format("{:g}", *c.paired.degreesOfFreedom) : "–",
         rounded(g.value, 2) + (g.interval ? " " + intervalInWords(g.interval) : ""),
         c.bayes.bf10 ? escaped(evidenceInWords(*c.bayes.bf10)) : "–"});
  }

  void sentences() {
    put("<details open><summary>{}</summary>", say("In sentences"));
    for (const auto& part : f_.cohorts) {
      put("<p><em>{}</em>: ", cohort(part.cohort));
      for (const auto& line : apaLines(part.within, s_.words)) put("{}. ", escaped(line));
      put("</p><ul>");
      for (const auto& comparison : part.within.rows) {
        std::string sentence;
        for (const auto& line : apaLines(comparison, f_.family, s_.words)) {
          sentence += (sentence.empty() ? "" : "; ") + line;
        }
        put("<li>{}: {}.</li>", pairOf(comparison), withSubscripts(escaped(sentence)));
      }
      put("</ul>");
    }
    put("</details>");
  }

  void between() {
    if (f_.between.empty()) return;
    table(
        say("Between cohorts, on participants’ means (exploratory): positive δ where the first has "
            "the larger values"),
        {say("Method"), "U", say("exact p"), say("Brunner–Munzel p"), say("Cliff’s δ")});
    std::string last;
    for (const auto& b : f_.between) {
      const std::string pair = cohort(b.cohort1) + " vs. " + cohort(b.cohort2);
      if (pair != last) rowOver(pair, 5);
      last = pair;
      row(
          {condition(b.condition),
           b.mannWhitney.u ? fmt::format("{:g}", *b.mannWhitney.u) : "–",
           escaped(pInWords(b.mannWhitney.p)),
           escaped(pInWords(b.brunnerMunzel.p)),
           rounded(b.cliff.delta, 2) +
               (b.cliff.interval ? " " + intervalInWords(b.cliff.interval) : "")});
    }
    endTable();
  }

  const FamilyResult& f_;
};

}  // namespace

std::string withinAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure) {
  return TestsWriter(section, family).all(figure);
}

}  // namespace study::report
