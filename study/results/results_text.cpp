#include "study/results/results_text.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "analysis/registry/registry.h"
#include "base/text_table.h"
#include "questionnaires/model/answer.h"
#include "study/results/vote_tables.h"
#include "study/words/counted.h"

namespace study {
namespace {

std::string padded(const std::string& text, std::size_t columns, bool toTheRight = false) {
  const std::string space(
      columns > base::characterCount(text) ? columns - base::characterCount(text) : 0, ' ');
  return toTheRight ? space + text : text + space;
}

class Writer {
 public:
  Writer(Study& study, const Results& results, Profile profile, Wording wording)
      : loaded_(study.protocol()),
        protocol_(loaded_.protocol),
        results_(results),
        profile_(profile),
        wording_(wording) {}

  std::string all() {
    head();
    const auto hasCompleted = [](const CohortFlow& flow) { return flow.completed > 0; };
    if (!results_.flow.empty() && std::ranges::none_of(results_.flow, hasCompleted)) {
      line("\nNobody has completed a session: there is nothing to compare yet.");
      return text_;
    }
    for (const auto& family : results_.families) {
      means(family);
      isPooled(profile_, family.family) ? writeAsPublished(family) : writeRecommended(family);
      flags(family);
    }
    if (!results_.votes.empty()) votes();
    if (!results_.instruments.empty()) scores();
    items();
    return text_;
  }

 private:
  void line(const std::string& words) { text_ += words + "\n"; }

  /// "p = .021"; "P = 0.021".
  std::string inWords(const std::optional<double>& p) const {
    return formatPWithSymbol(p, {}, wording_);
  }
  /// "[0.41, 2.42]"; "(0.41 to 2.42)".
  std::string inBrackets(const std::optional<analysis::Interval>& interval) const {
    const auto limits = formatInterval(interval, wording_, {});
    return wording_ == Wording::Vancouver && interval ? "(" + limits + ")" : limits;
  }

  const std::string& titleOf(const std::string& condition) const {
    return protocol_.condition(condition)->title;
  }
  static std::string_view titleOf(const analysis::TestRow& test) {
    return analysis::statisticalTest(test.id).title;
  }
  const std::string& cohortTitle(const std::string& cohort) const {
    return protocol_.cohort(cohort)->title.in("en");
  }

  bool hasNobody(const CohortResult& cohort) const {
    const auto flow = std::ranges::find(results_.flow, cohort.cohort, &CohortFlow::cohort);
    return flow != results_.flow.end() && flow->completed == 0;
  }

  void head() {
    line(protocol_.study.title);
    if (results_.runMode == RunMode::Simulated) {
      line("SIMULATED: nobody took part; these numbers say nothing about any method.");
    }
    if (results_.runMode == RunMode::Pilot) line("PILOT: not for publication.");
    for (const auto& flow : results_.flow) writeFlow(cohortTitle(flow.cohort), flow);
    for (const auto& [site, flow] : results_.siteFlow) writeFlow("Site " + site, flow);
    if (results_.changes.empty()) return;
    line("\nThe protocol was changed after participants had answered");
    for (const auto& change : results_.changes) line("  " + base::describe(change));
  }

  void writeFlow(const std::string& who, const CohortFlow& flow) {
    const int others = flow.declined + flow.withdrawn + flow.rejected + flow.abortedHardware;
    line(fmt::format(
        "{}: {} enrolled, {} completed, {} in progress, {} left or excluded{}",
        who,
        flow.enrolled,
        flow.completed,
        flow.inProgress,
        others,
        flow.erased > 0 ? fmt::format(", {} erased and counted nowhere below", flow.erased)
                        : std::string()));
  }

  void means(const FamilyResult& family) {
    line("\n" + family.family.title + ": mean μ and variance σ² of the keyed answers");
    std::string heading = padded("", 40);
    for (const auto& condition : family.cohorts.front().conditions) {
      heading += padded(titleOf(condition.name), 22, true);
    }
    line(heading);
    for (const auto& cohort : family.cohorts) {
      std::string row = padded(cohortTitle(cohort.cohort), 40);
      for (const auto& condition : cohort.conditions) row += momentsInWords(condition.answers);
      line(row);
      if (!cohort.sites) continue;
      for (const auto& site : cohort.sites->answers) {
        std::string ofSite = padded("  " + site.site, 40);
        for (const auto& answers : site.methods) ofSite += momentsInWords(answers);
        line(ofSite);
      }
    }
  }

  static std::string momentsInWords(const analysis::AnswerSample& answers) {
    const auto words = fmt::format(
        "{} / {} (n={})",
        rounded(answers.mean(), 2),
        rounded(answers.variance(), 2),
        answers.total());
    return padded(words, 22, true);
  }

  /// The tables of Profile::AsPublished. Tests that are not declared are marked as exploratory.
  void writeAsPublished(const FamilyResult& family) {
    const bool isCorrected = !correctionOf(family.family).empty();
    line(fmt::format(
        "\n{}: Welch's t-tests{}, alpha = {} ({})",
        family.family.title,
        isCorrected ? fmt::format(" with {} correction", correctionOf(family.family)) : "",
        family.family.alpha,
        family.isConfirmatory("welch") ? "declared: confirmatory" : "exploratory"));
    for (const auto& cohort : family.cohorts) {
      if (hasNobody(cohort)) {
        line(cohortTitle(cohort.cohort) + ": nobody has completed a session");
        continue;
      }
      line(
          cohortTitle(cohort.cohort) +
          (cohort.comparisons.alphaPerTest
               ? fmt::format(" (alpha per test {})", rounded(cohort.comparisons.alphaPerTest, 4))
               : ""));
      for (const auto& row : cohort.comparisons.rows) {
        comparison(row, family.isConfirmatory("welch"));
      }
    }
  }

  /// The correction of the pooled Welch's tests: the declared one if Welch's test is declared,
  /// otherwise Bonferroni's as in the paper.
  static std::string_view correctionOf(const protocols::Family& family) {
    return nameOf(
        family.test == protocols::TestType::Welch ? family.correction
                                                  : protocols::CorrectionType::Bonferroni);
  }

  void writeRecommended(const FamilyResult& family) {
    line(fmt::format(
        "\n{}: within people, alpha = {}\n  {}",
        family.family.title,
        family.family.alpha,
        family.isDeclared
            ? "declared, confirmatory: " + declaredInWords(family.family) +
                  "; all else is exploratory"
            : "not declared before the first participant and ever since: all is exploratory, also "
              "what the protocol names now, " +
                  declaredInWords(family.family)));
    for (const auto& cohort : family.cohorts) {
      if (hasNobody(cohort)) {
        line(cohortTitle(cohort.cohort) + ": nobody has completed a session");
        continue;
      }
      line(fmt::format(
          "{}: {} who judged every method{}",
          cohortTitle(cohort.cohort),
          words::counted(cohort.within.participants, "participant"),
          cohort.within.excludedParticipants.empty()
              ? ""
              : fmt::format(", {} left out", cohort.within.excludedParticipants.size())));
      for (const auto& words : apaLines(cohort.within, family.family, {}, wording_))
        line("  " + words);
      for (const auto& row : cohort.within.probabilities) probability(row, family.family.alpha);
      for (const auto& row : cohort.within.rows) {
        line("  " + titleOf(row.group1) + " vs. " + titleOf(row.group2));
        for (const auto& words : apaLines(row, family.family, {}, wording_)) line("    " + words);
      }
      if (cohort.sites) writeBySite(*cohort.sites);
      writeChecks(cohort);
    }
    writeBetween(family);
  }

  void probability(const analysis::TestRow& row, double alpha) {
    line(fmt::format(
        "  {}: answers of {:g} or more: observed {}, probability {}",
        titleOf(row.group1),
        row.additionalNumber("from").value_or(0.0),
        rounded(row.statistic.value, 2),
        row.effect.value ? fmt::format(
                               "{}, {:g} % CI {} (ordinal mixed model)",
                               rounded(row.effect.value, 2),
                               100.0 * (1.0 - alpha),
                               formatInterval(row.effectInterval, wording_, {}))
                         : "not defined: " + base::describe(row.reason)));
  }

  void writeBySite(const analysis::SiteAnalysis& sites) {
    for (const auto& row : sites.rows) {
      line("  By site, " + titleOf(row.group1) + " vs. " + titleOf(row.group2));
      for (const auto& site : row.sites) {
        line(fmt::format(
            "    {}: {}, mean difference {} {}",
            site.site,
            words::counted(site.test.n, "participant"),
            rounded(site.test.meanDifference, 2),
            inBrackets(site.interval)));
      }
      if (!row.pooled) {
        line("    not pooled: " + base::describe(row.reason));
        continue;
      }
      writePooled("all sites", row.pooled->knappHartung);
      line(fmt::format(
          "    heterogeneity: Q({}) = {}, {}, I² = {:.0f} %, τ² = {} (DerSimonian–Laird: {})",
          row.pooled->sites - 1,
          rounded(row.pooled->q, 2),
          inWords(row.pooled->heterogeneityP),
          100.0 * row.pooled->reml.iSquared,
          rounded(row.pooled->reml.tauSquared, 3),
          rounded(row.pooled->derSimonianLaird.tauSquared, 3)));
      for (const auto& without : row.leaveOneOut)
        writePooled("without " + without.site, without.pooled);
    }
  }

  void writePooled(const std::string& which, const analysis::PooledEstimate& pooled) {
    line(fmt::format(
        "    {}: {} {}, {} (random effects, REML, Knapp–Hartung)",
        which,
        rounded(pooled.estimate, 2),
        inBrackets(pooled.interval),
        inWords(pooled.p)));
  }

  /// The effect of the position in the order, and the reliability of the scale.
  void writeChecks(const CohortResult& cohort) {
    const auto& slope = cohort.position.slope;
    line(
        slope.p ? fmt::format(
                      "  Order: {} points from one position to the next {}, {}",
                      rounded(slope.meanDifference, 2),
                      inBrackets(cohort.position.slopeInterval),
                      inWords(slope.p))
                : "  Order: no slope over positions: " + base::describe(slope.reason));
    for (const auto& method : cohort.checks.methods) {
      std::string defined;
      const auto add = [&](const std::string& text) {
        defined += (defined.empty() ? "" : ", ") + text;
      };
      if (method.alpha.value) add("Cronbach's α = " + rounded(method.alpha.value, 2));
      if (method.omega.value) add("ω = " + rounded(method.omega.value, 2));
      if (method.normality.p) {
        add("Shapiro–Wilk " + inWords(method.normality.p));
      }
      if (!defined.empty()) line("  Scale, " + titleOf(method.method) + ": " + defined);
      if (method.alpha.value && !method.alpha.reason.empty())
        line("    " + base::describe(method.alpha.reason));
    }
  }

  void writeBetween(const FamilyResult& family) {
    if (family.between.empty()) return;
    line("Between cohorts, on participants' means (exploratory)");
    for (const auto& row : family.between) {
      line("  " + titleOf(row.condition) + ", " + betweenInWords(row));
    }
  }

  std::string betweenInWords(const BetweenResult& row) const {
    std::string words = cohortTitle(row.cohort1) + " vs. " + cohortTitle(row.cohort2) + ": ";
    const auto& ranks = row.test("mann_whitney");
    if (!ranks.p) return words + "not defined: " + base::describe(ranks.reason);
    words += fmt::format(
        "U = {:g}, exact {}, Cliff's δ = {} {}",
        ranks.statistic.value.value_or(0.0),
        inWords(ranks.p),
        rounded(ranks.effect.value, 2),
        inBrackets(ranks.effectInterval));
    for (const auto& test : row.tests) {
      if (test.id == "mann_whitney" || !test.p) continue;
      const auto name =
          test.id == "brunner_munzel" ? std::string("Brunner–Munzel") : std::string(titleOf(test));
      words += "; " + name + " " + inWords(test.p);
    }
    return words;
  }

  void comparison(const analysis::TestRow& row, bool isConfirmatory) {
    std::string words = "  " + padded(titleOf(row.group1) + " vs. " + titleOf(row.group2), 38);
    if (!row.p) {
      line(words + "not defined: " + base::describe(row.reason));
      return;
    }
    words += fmt::format(
        "difference {:>6}, t({}) = {:>6}, {:<11} adjusted {:<11}",
        rounded(row.estimate.value, 2),
        rounded(row.df, 2),
        rounded(row.statistic.value, 2),
        inWords(row.p),
        inWords(row.adjusted));
    line(words + (isConfirmatory && row.isSignificant.value_or(false) ? " significant" : ""));
  }

  /// One line for each kind of flag, with its cohorts.
  void flags(const FamilyResult& family) {
    const auto raised = flagsByKind(family, isPooled(profile_, family.family));
    if (raised.empty()) return;
    line("\nWhat a reader has to know");
    for (const auto& [flag, found] : raised) {
      line(fmt::format("  [{}]", flag->id));
      for (const auto& [cohort, what] : found) {
        line("    " + cohortTitle(cohort) + ": " + what->inEnglish());
      }
      line(fmt::format("    Why: {}", base::describe(flag->why)));
      line(fmt::format("    What to do: {}", base::describe(flag->remedy)));
    }
  }

  void votes() {
    line("\nPreferences: how many named each method");
    for (const auto& table : voteTables(results_)) {
      for (const auto& cohort : table.cohorts) {
        const auto& title = cohortTitle(cohort.cohort);
        for (const auto* vote : cohort.rounds) {
          const auto& exactP = vote->test.exactP;
          const auto& p = exactP ? exactP : vote->test.p;
          const bool isTested = p && vote->votes.total() > 1;
          line(
              votesInWords(title, "after " + vote->block, vote->votes) +
              (isTested ? (exactP ? "exact " : "χ² ") + inWords(p) : "") +
              (vote->leftOut > 0
                   ? fmt::format("; not counted: {} without all alternatives felt", vote->leftOut)
                   : ""));
        }
        if (cohort.rounds.size() > 1) line(votesInWords(title, "Sum", cohort.sum));
      }
      if (table.cohorts.size() > 1) line(votesInWords("Total", "", table.total));
    }
  }

  std::string votesInWords(
      const std::string& who, const std::string& when, const analysis::VoteCounts& votes) const {
    std::string row = padded(who, 40) + padded(when, 22);
    for (const auto& share : votes.shares()) {
      row += padded(titleOf(share.option) + " " + std::to_string(share.votes), 18);
    }
    return row;
  }

  void scores() {
    line("\nScores of questionnaires: mean, standard deviation, 95 % interval");
    for (const auto& instrument : results_.instruments) {
      for (const auto& score : instrument.scores) {
        if (score.values.empty()) continue;
        const auto about = score.condition.empty() ? score.occasion : titleOf(score.condition);
        line(fmt::format(
            "{}{} {}{}, n = {}",
            padded(instrument.instrument + ", " + score.score, 40),
            padded(cohortTitle(score.cohort) + (about.empty() ? "" : ", " + about), 44),
            rounded(score.mean, 2),
            score.standardDeviation
                ? " " + rounded(score.standardDeviation, 2) + " " + inBrackets(score.interval)
                : std::string(),
            score.values.size()));
      }
    }
  }

  /// One line for each item; free texts are only counted.
  void items() {
    const auto& [items, quotes] = results_.answers;
    if (!items.empty()) {
      line(
          "\nEvery item by itself, as answered: mean, standard deviation, median and range of "
          "participants' means; forms that chose each option");
    }
    for (const auto& one : items) {
      const auto about =
          cohortTitle(one.cohort) + (one.condition.empty() ? "" : ", " + titleOf(one.condition));
      line(
          padded(one.instrument + ", " + one.item + "  ", 40) + padded(about + "  ", 44) +
          (one.mean ? numbersOf(one) : choicesOf(one)));
    }
    for (auto at = quotes.begin(); at != quotes.end();) {
      const auto next = std::find_if(at, quotes.end(), [&](const auto& quote) {
        return quote.instrument != at->instrument || quote.item != at->item;
      });
      line(
          padded(at->instrument + ", " + at->item + "  ", 40) +
          words::counted(static_cast<std::size_t>(next - at), "text") + ", quoted in the report");
      at = next;
    }
  }

  /// Four digits, or all before the point where there are more.
  static std::string shortened(double value) {
    constexpr double kMoreDigits = 9999.5;
    return std::abs(value) < kMoreDigits ? fmt::format("{:.4g}", value)
                                         : fmt::format("{:.0f}", value);
  }

  static std::string numbersOf(const ItemSummary& one) {
    return fmt::format(
        "{}{}, {}, {} … {}, n = {}",
        rounded(one.mean, 2),
        one.standardDeviation ? " " + rounded(one.standardDeviation, 2) : std::string(),
        rounded(one.median, 2),
        shortened(*one.least),
        shortened(*one.most),
        one.values.size());
  }

  std::string choicesOf(const ItemSummary& one) const {
    const auto* item = loaded_.instrument(one.instrument)->item(one.item);
    std::string text;
    for (const auto& [id, times] : one.options) {
      if (times == 0) continue;
      const auto label = questionnaires::labelOf(*item, id, "en");
      text += fmt::format("{}{} {}", text.empty() ? "" : ", ", label.empty() ? id : label, times);
    }
    return text + fmt::format(", n = {}", one.answers);
  }

  const protocols::LoadedProtocol& loaded_;
  const protocols::Protocol& protocol_;
  const Results& results_;
  Profile profile_;
  Wording wording_;
  std::string text_;
};

}  // namespace

std::string resultsAsText(Study& study, const Results& results, Profile profile, Wording wording) {
  return Writer(study, results, profile, wording).all();
}

}  // namespace study
