#include <algorithm>

#include "study/report/html_writer.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"

namespace study::report {
namespace {

/// Writes one family's differences by site.
class SitesWriter : HtmlWriter {
 public:
  SitesWriter(const ReportSection& section, const FamilyResult& family)
      : HtmlWriter(section), result_(family) {}

  std::string all(const std::string& forest) {
    put("<h4>{}</h4>", say("By site"));
    putFigure(
        forest,
        say("Mean differences within people at each site with their {:g} % intervals; the area of "
            "a square is the site’s weight. The diamond is the pooled difference with its "
            "interval: random effects, τ² by REML, the standard error by Knapp and Hartung. An "
            "arrow: the interval goes on.",
            100.0 * (1.0 - result_.family.alpha)));
    table(
        say("Differences of participants’ means by site"),
        {say("Site"),
         kN,
         say("Difference"),
         say("{:g} % CI", 100.0 * (1.0 - result_.family.alpha)),
         kP,
         say("Weight")});
    forEachComparison([&](const auto& sites, const auto& row) { comparison(sites, row); });
    endTable();
    note(
        "Exploratory. One effect: sites differ by chance alone. Random effects: the difference "
        "itself varies between sites, with the variance τ². Of few sites τ² and I² are known "
        "badly; a Q that is not significant does not show that sites agree. Of sites with fewer "
        "than two participants, or whose participants all differ alike, nothing is pooled.");
    return std::move(html_);
  }

 private:
  template <typename Write>
  void forEachComparison(Write write) {
    for (const auto& part : result_.cohorts) {
      if (!part.sites || !hasAnswers(part)) continue;
      for (const auto& row : part.sites->rows) {
        rowOver(
            cohort(part.cohort) + ": " + condition(row.group1) + " vs. " + condition(row.group2));
        write(*part.sites, row);
      }
    }
  }

  void comparison(const analysis::SiteAnalysis& sites, const analysis::SiteComparison& comparison) {
    for (const auto& site : comparison.sites) {
      row(
          {escaped(site.site),
           std::to_string(site.test.n),
           cellOf(site.test.meanDifference, 2),
           cellOf(site.interval),
           cellOfP(site.test.p),
           site.weight > 0.0 ? rounded(100.0 * site.weight, 0) + " %" : std::string()});
    }
    if (comparison.pooled) {
      putPooled(say("All sites, one effect"), comparison.pooled->common);
      putPooled(
          say("All sites, random effects (REML, Knapp–Hartung)"), comparison.pooled->knappHartung);
      putHeterogeneity(*comparison.pooled);
    } else {
      rowOver(say("not pooled: {}", section_.inWords(comparison.reason)));
    }
    putModel(say("Mixed model, sites as random effects"), comparison.randomSites);
    if (const auto& fit = sites.randomSites.fit) {
      const auto& components = fit->components;
      rowOver(
          say("variance between sites {}, of the difference between sites {}",
              rounded(components[components.size() - 2].variance, 3),
              rounded(components.back().variance, 3)));
    }
  }

  void putPooled(const std::string& which, const analysis::PooledEstimate& pooled) {
    row({which, "", rounded(pooled.estimate, 2), cellOf(pooled.interval), cellOfP(pooled.p), ""});
  }

  void putHeterogeneity(const analysis::MetaAnalysis& pooled) {
    rowOver(
        say("Heterogeneity: Q({}) = {}, p {}; I² = {} %; τ² = {}",
            pooled.sites - 1,
            rounded(pooled.q, 2),
            equalsOfP(pooled.heterogeneityP),
            rounded(100.0 * pooled.reml.iSquared, 0),
            rounded(pooled.reml.tauSquared, 3)));
  }

  void putModel(const std::string& which, const analysis::TestRow& test) {
    if (!test.p) {
      return row({which}, notDefined(test.reason));
    }
    row({which, "", rounded(test.estimate.value, 2), cellOf(test.interval), cellOfP(test.p), ""});
  }

  const FamilyResult& result_;
};

}  // namespace

std::string sitesAsHtml(
    const ReportSection& section, const FamilyResult& family, const std::string& figure) {
  const auto isAnySite =
      std::ranges::any_of(family.cohorts, [](const auto& part) { return part.sites.has_value(); });
  return isAnySite ? SitesWriter(section, family).all(figure) : std::string();
}

}  // namespace study::report
