#include "study/report/family_checks.h"

#include <algorithm>

#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

/// Writes one family's checks.
class ChecksWriter : HtmlWriter {
 public:
  ChecksWriter(const ReportSection& section, const FamilyResult& family)
      : HtmlWriter(section), f_(family) {}

  std::string all(const std::string& positions) {
    if (std::ranges::any_of(f_.cohorts, hasSlope)) {
      put("<h4>{}</h4>", say("The order"));
      order();
      figure(
          positions,
          "How methods were judged that came first, second and so on: means over participants with "
          "95 % intervals, after the mean of each method has been taken away. Where orders are not "
          "balanced, part of the order’s effect has gone with it.");
    }
    if (std::ranges::any_of(f_.cohorts, hasChecks)) {
      put("<h4>{}</h4>", say("The scale"));
      scale();
    }
    return std::move(html_);
  }

 private:
  static bool hasSlope(const CohortResult& part) { return part.position.slope.p.has_value(); }

  static bool isChecked(const analysis::MethodChecks& method) {
    return method.alpha.value || method.omega.value || method.normality.w;
  }
  static bool hasChecks(const CohortResult& part) {
    return std::ranges::any_of(part.checks.methods, isChecked);
  }

  void order() {
    put("<ul>");
    for (const auto& part : f_.cohorts) {
      if (!hasAnswers(part)) continue;
      const auto& slope = part.position.slope;
      if (!slope.p) {
        put("<li>{}: {}</li>",
            cohort(part.cohort),
            say("no slope over positions: {}.", s_.inWords(slope.reason)));
        continue;
      }
      put("<li>{}: {}</li>",
          cohort(part.cohort),
          say("{} points from one position to the next, 95 % CI {}, t({:g}) = {}, p {}.",
              rounded(slope.meanDifference, 2),
              formatInterval(part.position.slopeInterval, s_.wording, s_.words),
              slope.degreesOfFreedom.value_or(0.0),
              rounded(slope.t, 2),
              equalsOfP(slope.p)));
    }
    put("</ul>");
  }

  void scale() {
    table(
        say("Reliability of the statements and distribution of participants’ means"),
        {say("Method"),
         say("Statements"),
         say("Cronbach’s α"),
         say("95 % CI"),
         say("McDonald’s ω"),
         say("Shapiro–Wilk W"),
         kP});
    for (const auto& part : f_.cohorts) {
      if (!hasChecks(part)) continue;
      const auto& spread = part.checks.spread;
      rowOver(
          cohort(part.cohort) + (spread.p ? say(": Brown–Forsythe F({:g}, {:g}) = {}, p {}",
                                                *spread.degreesOfFreedom1,
                                                *spread.degreesOfFreedom2,
                                                rounded(spread.f, 2),
                                                equalsOfP(spread.p))
                                          : std::string()));
      for (const auto& method : part.checks.methods) {
        if (!isChecked(method)) continue;
        row(
            {condition(method.method),
             std::to_string(method.alpha.items),
             cellOf(method.alpha.value, 2),
             cellOf(method.alpha.interval),
             cellOf(method.omega.value, 2) + (method.omega.isImproper ? " †" : ""),
             cellOf(method.normality.w, 3),
             cellOfP(method.normality.p)});
      }
    }
    endTable();
    note(
        "α and ω: whether the statements about a method agree; † marks an ω whose factor explains "
        "a "
        "statement completely. W: whether participants’ means are normal, and Brown and Forsythe’s "
        "F whether methods vary alike; no test above depends on either.");
  }

  const FamilyResult& f_;
};

}  // namespace

std::string checksAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure) {
  return ChecksWriter(section, family).all(figure);
}

}  // namespace study::report
