#include "study/report/html_report.h"

#include <algorithm>

#include <fmt/format.h>

#include "study/data_table.h"
#include "study/report/html_text.h"
#include "study/results_text.h"

namespace study::report {
namespace {

std::string interval(const std::optional<analysis::Interval>& i) {
  return i ? fmt::format("[{:.2f}, {:.2f}]", i->low, i->high) : "–";
}

/// Writes one study.
class SectionWriter {
 public:
  explicit SectionWriter(const ReportSection& section) : s_(section) {}

  std::string all() {
    head();
    flow();
    for (std::size_t i = 0; i < s_.results.families.size(); ++i) family(i);
    votes();
    felt();
    quality();
    warnings();
    methods();
    return html_;
  }

 private:
  template <typename... Args>
  void put(fmt::format_string<Args...> format, Args&&... args) {
    html_ += fmt::format(format, std::forward<Args>(args)...);
    html_ += '\n';
  }

  void figure(const std::string& svg, const std::string& caption) {
    if (svg.empty()) {
      put("<p class=\"note\">(No figure: this palpate was built without Qt. {})</p>",
          escaped(caption));
      return;
    }
    put("<figure>{}<figcaption>{}</figcaption></figure>", svg, escaped(caption));
  }

  void head() {
    put("<h2>{}</h2>", escaped(s_.protocol.study.title));
    if (s_.results.runMode == RunMode::Simulated) {
      put("<p class=\"banner\">Simulated: nobody took part. These numbers show what the program "
          "does; they "
          "say nothing about any method.</p>");
    }
    if (s_.results.runMode == RunMode::Pilot) {
      put("<p class=\"banner pilot\">Pilot sessions: not for publication.</p>");
    }
    if (!s_.protocol.study.description.empty())
      put("<p>{}</p>", escaped(s_.protocol.study.description));
  }

  void flow() {
    put("<h3>Participants</h3><table><caption>Who took part</caption><thead><tr><th>Cohort</th>"
        "<th>Enrolled</th><th>Completed</th><th>In progress</th><th>Declined</th><th>Withdrawn</th>"
        "<th>Rejected</th><th>Device failed</th></tr></thead><tbody>");
    for (const auto& f : s_.results.flow) {
      put("<tr><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</"
          "td><td>{}</td></tr>",
          escaped(s_.cohortTitle(f.cohort)),
          f.enrolled,
          f.completed,
          f.inProgress,
          f.declined,
          f.withdrawn,
          f.rejected,
          f.abortedHardware);
    }
    put("</tbody></table><p class=\"note\">Only completed sessions count below, and of these only "
        "steps that "
        "were finished and not repeated.</p>");
  }

  void family(std::size_t index) {
    const auto& f = s_.results.families[index];
    put("<h3>{}</h3>", escaped(f.family.title));
    means(f);
    figure(
        index < s_.figures.likert.size() ? s_.figures.likert[index] : "",
        "How often each point was chosen. Answers to negative statements are reversed, so that "
        "right is "
        "good; the middle of the scale is centred. Numbers are counts.");
    comparisons(f);
  }

  void means(const FamilyResult& f) {
    put("<table><caption>Mean μ and variance σ² of the answers (n "
        "answers)</caption><thead><tr><th></th>");
    for (const auto& c : f.cohorts.front().conditions) {
      put("<th colspan=\"3\">{}</th>", escaped(s_.conditionTitle(c.name)));
    }
    put("</tr><tr><th></th>");
    for (std::size_t i = 0; i < f.cohorts.front().conditions.size(); ++i) {
      put("<th>μ</th><th>σ²</th><th>n</th>");
    }
    put("</tr></thead><tbody>");
    for (const auto& cohort : f.cohorts) {
      put("<tr><td>{}</td>", escaped(s_.cohortTitle(cohort.cohort)));
      for (const auto& c : cohort.conditions) {
        put("<td>{}</td><td>{}</td><td>{}</td>",
            rounded(c.counts.mean(), 1),
            rounded(c.counts.variance(), 1),
            c.counts.total());
      }
      put("</tr>");
    }
    put("</tbody></table>");
  }

  void comparisons(const FamilyResult& f) {
    const bool isCorrected = f.family.correction == protocols::CorrectionType::Bonferroni;
    put("<table><caption>Welch’s t-tests{}, α = {}</caption><thead><tr><th>Comparison</th>"
        "<th>Difference</th><th>95 % CI</th><th>t</th><th>df</th><th>p</th><th>adjusted "
        "p</th></tr></thead>"
        "<tbody>",
        isCorrected ? " with Bonferroni correction" : "",
        exactly(f.family.alpha));
    for (const auto& cohort : f.cohorts) {
      put("<tr><td colspan=\"7\"><em>{}{}</em></td></tr>",
          escaped(s_.cohortTitle(cohort.cohort)),
          cohort.comparisons.alphaPerTest
              ? fmt::format(", α per test {:.4f}", *cohort.comparisons.alphaPerTest)
              : "");
      for (const auto& row : cohort.comparisons.rows) comparison(row);
    }
    put("</tbody></table><p class=\"note\">Profile <em>as-published</em>: answers of all "
        "statements and rounds "
        "are pooled per participant and method and treated as independent, as in the punch paper; "
        "bold: "
        "p ≤ α per test. Several answers of one person are not independent, so these p values may "
        "be too "
        "small or too large.</p>");
  }

  void comparison(const analysis::PairwiseComparison& row) {
    const auto& w = row.welch;
    put("<tr{}><td>{} vs. {}</td>",
        row.isSignificant.value_or(false) ? " class=\"yes\"" : "",
        escaped(s_.conditionTitle(row.group1)),
        escaped(s_.conditionTitle(row.group2)));
    if (!w.p) {
      put("<td class=\"words\" colspan=\"6\">not defined: {}</td></tr>", escaped(w.reason));
      return;
    }
    put("<td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td><td>{}</td></tr>",
        rounded(w.difference, 2),
        interval(row.interval),
        rounded(w.t, 2),
        rounded(w.degreesOfFreedom, 2),
        escaped(pInWords(w.p)),
        escaped(pInWords(row.adjustedP)));
  }

  void votes() {
    if (s_.results.votes.empty()) return;
    put("<h3>Preferences</h3><table><caption>How many participants named each "
        "method</caption><thead><tr>"
        "<th>Cohort</th><th class=\"words\">After</th>");
    for (const auto& share : s_.results.votes.front().votes.shares()) {
      put("<th>{}</th>", escaped(s_.conditionTitle(share.option)));
    }
    put("</tr></thead><tbody>");
    for (const auto& cohort : s_.results.flow) {
      for (const auto& vote : s_.results.votes) {
        if (vote.cohort != cohort.cohort) continue;
        put("<tr><td>{}</td><td class=\"words\">{}</td>",
            escaped(s_.cohortTitle(vote.cohort)),
            escaped(vote.block));
        for (const auto& share : vote.votes.shares()) put("<td>{}</td>", share.votes);
        put("</tr>");
      }
    }
    put("</tbody></table>");
    figure(s_.figures.votes, "Preferences by cohort and round.");
  }

  void felt() {
    put("<h3>What each alternative felt like</h3>");
    for (const auto& svg : s_.figures.felt) {
      figure(
          svg,
          "Force at the handle while the tool closed or advanced, over travel: median and the "
          "middle 80 % of all samples of all trials. Dashed, for bone: what its material gives "
          "where nothing has been reamed away.");
    }
    if (s_.figures.felt.empty()) figure("", "Force over travel for every alternative.");
    put("<table><caption>Manipulation check: root mean square difference of the median "
        "forces</caption>"
        "<thead><tr><th>Pair</th><th>[N]</th></tr></thead><tbody>");
    for (std::size_t i = 0; i < s_.curves.size(); ++i) {
      for (std::size_t j = i + 1; j < s_.curves.size(); ++j) {
        const auto difference = rmsDifference(s_.curves[i], s_.curves[j]);
        if (!difference) continue;
        put("<tr><td>{} vs. {}</td><td>{:.2f}</td></tr>",
            escaped(s_.conditionTitle(s_.curves[i].condition)),
            escaped(s_.conditionTitle(s_.curves[j].condition)),
            *difference);
      }
    }
    put("</tbody></table>");
    feltAgainstMaterial();
  }

  void feltAgainstMaterial() {
    const bool isBone = std::any_of(
        s_.curves.begin(), s_.curves.end(), [](const auto& curve) { return rmsFromMeant(curve); });
    if (!isBone) return;
    put("<table><caption>Felt against the material: root mean square difference of the median "
        "force</caption><thead><tr><th>Alternative</th><th>[N]</th></tr></thead><tbody>");
    for (const auto& curve : s_.curves) {
      const auto difference = rmsFromMeant(curve);
      if (!difference) continue;
      put("<tr><td>{}</td><td>{:.2f}</td></tr>",
          escaped(s_.conditionTitle(curve.condition)),
          *difference);
    }
    put("</tbody></table>");
  }

  void quality() {
    const auto& q = s_.quality;
    put("<h3>Rendering quality</h3><p>{} trials with {} cuts or strokes: {} PASS, {} WARN, {} "
        "FAIL. The "
        "scene asked for more than the force limit for {:.1f} s of {:.1f} s of contact. {}</p>",
        q.trials,
        q.cuts,
        q.pass,
        q.warn,
        q.fail,
        q.saturated,
        q.contact,
        q.worstLateness ? fmt::format(
                              "In the worst trial 99 % of the ticks were at most {:.0f} µs late.",
                              *q.worstLateness)
                        : "The trials ran in virtual time, so there is no lateness to report.");
    if (q.reasons.empty()) return;
    put("<ul>");
    for (const auto& reason : q.reasons) put("<li>{}</li>", escaped(reason));
    put("</ul>");
  }

  void warnings() {
    if (s_.warnings.empty()) return;
    put("<h3>What to know about the design</h3><ul>");
    for (const auto& warning : s_.warnings) {
      put("<li>{}{} <span class=\"note\">({})</span></li>",
          escaped(warning.what),
          warning.fix.empty() ? "." : "; " + escaped(warning.fix) + ".",
          escaped(warning.path));
    }
    put("</ul>");
  }

  void methods() {
    put("<h3>How this was made</h3><p>palpate {}; protocol <em>{}</em> version {}, SHA-256 "
        "<code>{}</code>; "
        "study <code>{}</code>, seed {}. Means and variances (n − 1) come from integer counts; "
        "Welch’s "
        "t-test has real degrees of freedom; p values are adjusted before they are rounded.</p>",
        appVersion(),
        escaped(s_.protocol.study.id),
        escaped(s_.protocol.study.version),
        s_.protocolHash,
        s_.uuid,
        s_.seed);
    put("<p>Instruments:</p><ul>");
    for (const auto& i : s_.instruments) {
      put("<li>{} ({}){}</li>",
          escaped(i.title.in("en")),
          escaped(i.id),
          i.source.citation.empty() ? "" : ": " + escaped(i.source.citation));
    }
    put("</ul>");
  }

  const ReportSection& s_;
  std::string html_;
};

}  // namespace

std::string asHtml(const std::vector<ReportSection>& sections) {
  const bool isOne = sections.size() == 1;
  const std::string title = isOne ? sections.front().protocol.study.title : "Face-validity studies";
  std::string body =
      "<h1>" + (isOne ? "Results of a face-validity study" : escaped(title)) + "</h1>\n";
  for (const auto& section : sections) body += SectionWriter(section).all();
  return htmlPage(title, body);
}

}  // namespace study::report
