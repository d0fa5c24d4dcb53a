#include "study/report/tables/statistics_tables.h"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "analysis/registry/registry.h"
#include "study/model/data_table.h"
#include "study/report/study_parts.h"
#include "study/results/vote_tables.h"

namespace study::report {
namespace {

using Cells = std::vector<Cell>;

/// A name of analysis::TestRow as it is printed: "χ²" for "chi2".
std::string symbolOf(std::string_view name) {
  constexpr std::array<std::pair<std::string_view, std::string_view>, 8> kSymbols{
      {{"chi2", "χ²"},
       {"cliff_delta", "δ"},
       {"rank_biserial", "r"},
       {"kendall_w", "W"},
       {"partial_eta2", "η²"},
       {"odds_ratio", "OR"},
       {"bf10", "BF"},
       {"icc", "ICC"}}};
  const auto* const found =
      std::ranges::find(kSymbols, name, &std::pair<std::string_view, std::string_view>::first);
  return std::string(found == kSymbols.end() ? name : found->second);
}

/// "t(39.30) = 4.87".
std::string statisticOf(const analysis::TestRow& test) {
  const auto& [name, value] = test.statistic;
  if (!value) return {};
  std::string text = symbolOf(name);
  if (test.df) {
    const auto second = test.df2 ? fmt::format(", {:.4g}", *test.df2) : std::string();
    text += fmt::format("({:.4g}{})", *test.df, second);
  }
  return text + " = " + rounded(value, 2);
}

/// "g_z = 1.12 [0.30, 1.90]".
std::string effectOf(const analysis::TestRow& test) {
  const auto& [name, value] = test.effect;
  if (!value) return {};
  const auto number = name == "bf10" ? formatBayesFactor(*value) : rounded(value, 2);
  return symbolOf(name) + " " + withRelationSign(number) +
         (test.effectInterval ? " " + formatInterval(test.effectInterval) : std::string());
}

std::string countOf(const analysis::TestRow& test) {
  if (!test.n1) return {};
  return test.n2 ? fmt::format("{} + {}", *test.n1, *test.n2) : std::to_string(*test.n1);
}

std::string orNothing(const std::optional<double>& value) {
  return value ? rounded(value, 2) : std::string();
}

std::string orNothing(const std::optional<analysis::Interval>& interval) {
  return interval ? formatInterval(interval) : std::string();
}

/// @param title  shown above the table
DataTable tableOf(std::string name, std::string title, std::vector<Heading> headings) {
  return {.name = std::move(name), .description = std::move(title), .columns = std::move(headings)};
}

class TablesWriter {
 public:
  TablesWriter(const ReportSection& section, Profile profile)
      : section_(section), profile_(profile) {}

  std::vector<DataTable> all() {
    for (const auto& family : section_.results.families) {
      comparisons(family);
      addSiteDifferences(family);
    }
    means();
    for (const auto& votes : voteTables(section_.results)) preferences(votes);
    items();
    scores();
    remarks();
    return std::move(tables_);
  }

 private:
  template <typename... Args>
  std::string say(std::string_view english, Args&&... args) const {
    return section_.words.say(english, std::forward<Args>(args)...);
  }

  /// The heading of a column of words, which may begin with a title of the protocol.
  Heading words(std::string_view english) const { return Heading::ofWords(say(english)); }
  Heading number(std::string_view english) const { return {say(english)}; }

  void add(DataTable table) {
    if (!table.rows.empty()) tables_.push_back(std::move(table));
  }

  std::string pairOf(const analysis::TestRow& test) const {
    return section_.conditionTitle(test.group1) + " vs. " + section_.conditionTitle(test.group2);
  }

  // --- Comparisons ---

  /// What is often the same in all rows comes first, because a window says it once; then what a
  /// reader looks for: the difference, its interval and p.
  std::vector<Heading> headingsOf(const FamilyResult& family, bool isOfAnswers) const {
    std::vector<Heading> headings{
        words("Cohort"), words("Comparison"), isOfAnswers ? number("Answers") : Heading{"n"}};
    if (isOfAnswers) headings.push_back(number("People"));
    headings.insert(
        headings.end(),
        {words("Test"),
         number("Difference"),
         Heading{say("{:g} % CI", 100.0 * (1.0 - family.family.alpha))},
         Heading{"p"},
         number("adjusted p"),
         words("In words"),
         words("Statistic"),
         words("Effect size")});
    if (isOfAnswers && profile_ == Profile::Declared) {
      const auto next = std::ranges::find(headings, say("In words"), &Heading::name);
      headings.insert(next, number("p within people"));
    }
    return headings;
  }

  void comparisons(const FamilyResult& family) {
    const bool isOfAnswers = isPooled(profile_, family.family);
    auto table = tableOf(family.family.id, family.family.title, headingsOf(family, isOfAnswers));
    for (const auto& part : family.cohorts) {
      const auto people =
          isOfAnswers ? std::optional(part.table.participants.size()) : std::nullopt;
      const auto row = [&](const std::string& groups, const analysis::TestRow& test) {
        table.rows.push_back(
            cellsOf(family, section_.cohortTitle(part.cohort), groups, people, test, test));
      };
      if (!hasAnswers(part)) {
        table.rows.push_back(cellsWithoutAnswers(section_.cohortTitle(part.cohort), isOfAnswers));
        continue;
      }
      switch (profile_) {
        case Profile::Declared:
          for (const auto& one : declaredIn(family, part)) {
            table.rows.push_back(cellsOf(
                family,
                section_.cohortTitle(part.cohort),
                section_.conditionTitle(one.group1) + " vs. " + section_.conditionTitle(one.group2),
                people,
                *one.test,
                *one.difference,
                isOfAnswers ? std::optional(pWithin(part, one.group1, one.group2)) : std::nullopt));
          }
          break;
        case Profile::AsPublished:
          for (const auto& test : part.comparisons.rows) row(pairOf(test), test);
          break;
        case Profile::Recommended:
          for (const auto& test : part.within.overall) row(say("All methods"), test);
          for (const auto& pair : part.within.rows) {
            const auto groups = section_.conditionTitle(pair.group1) + " vs. " +
                                section_.conditionTitle(pair.group2);
            for (const auto& test : pair.tests) row(groups, test);
          }
          break;
      }
    }
    if (profile_ == Profile::Recommended) {
      for (const auto& pair : family.between) {
        for (const auto& test : pair.tests) {
          const auto who =
              section_.cohortTitle(pair.cohort1) + " vs. " + section_.cohortTitle(pair.cohort2);
          table.rows.push_back(
              cellsOf(family, who, section_.conditionTitle(pair.condition), {}, test, test));
        }
      }
    }
    add(std::move(table));
  }

  /// What a row of comparisons() has after its numbers of answers and people.
  struct Outcome {
    std::string test;
    std::string difference;
    std::string interval;
    std::string p;
    std::string adjusted;
    std::optional<std::string> within;  ///< std::nullopt: the table has no such column
    std::string inWords;
    std::string statistic;
    std::string effect;
  };

  /// Appends @p outcome in the order of headingsOf().
  static void append(Cells& cells, const Outcome& outcome) {
    for (const auto& cell :
         {outcome.test, outcome.difference, outcome.interval, outcome.p, outcome.adjusted}) {
      cells.emplace_back(cell);
    }
    if (outcome.within) cells.emplace_back(*outcome.within);
    for (const auto& cell : {outcome.inWords, outcome.statistic, outcome.effect}) {
      cells.emplace_back(cell);
    }
  }

  /// @param people  who gave the answers; std::nullopt if n is the number of people
  /// @param difference  has the estimate, its interval and the effect; often @p test itself
  /// @param within  see pWithin(); std::nullopt where the table has no such column
  Cells cellsOf(
      const FamilyResult& family,
      const std::string& who,
      const std::string& groups,
      const std::optional<std::size_t>& people,
      const analysis::TestRow& test,
      const analysis::TestRow& difference,
      const std::optional<std::string>& within = std::nullopt) const {
    const auto& estimate = difference.estimate;
    const bool isOfPoints = estimate.name == "difference";
    Cells cells{who, groups, countOf(test)};
    if (people) cells.emplace_back(std::to_string(*people));
    append(
        cells,
        {.test = say(shortNameOf(test.id)),
         .difference = isOfPoints ? orNothing(estimate.value) : std::string(),
         .interval = isOfPoints ? orNothing(difference.interval) : std::string(),
         .p = test.p ? formatP(test.p) : std::string(),
         .adjusted = test.adjusted && isCorrected(family) ? formatP(test.adjusted) : std::string(),
         .within = within,
         .inWords = inWords(family, test, estimate.value),
         .statistic = statisticOf(test),
         .effect = effectOf(difference)});
    return cells;
  }

  /// The row of a cohort without answers.
  Cells cellsWithoutAnswers(const std::string& who, bool isOfAnswers) const {
    Cells cells{who, std::string(), std::string()};
    if (isOfAnswers) cells.emplace_back(std::string());
    const bool hasWithin = isOfAnswers && profile_ == Profile::Declared;
    append(
        cells,
        {.within = hasWithin ? std::optional(std::string()) : std::nullopt,
         .inWords = say("No answers yet.")});
    return cells;
  }

  /// p of the paired t-test of people's means, adjusted as in the report.
  static std::string pWithin(
      const CohortResult& part, const std::string& group1, const std::string& group2) {
    for (const auto& row : part.within.rows) {
      if (row.group1 != group1 || row.group2 != group2) continue;
      const auto& test = row.test("paired_t");
      const auto& p = test.adjusted ? test.adjusted : test.p;
      return p ? formatP(p) : "–";
    }
    return "–";
  }

  /// The pooled tests of a study that does not declare them are corrected as in the punch paper.
  bool isCorrected(const FamilyResult& family) const {
    return profile_ == Profile::AsPublished || !nameOf(family.family.correction).empty();
  }

  std::string inWords(
      const FamilyResult& family,
      const analysis::TestRow& test,
      const std::optional<double>& difference) const {
    if (!test.p && (!test.effect.value || family.isNamed(test.id))) {
      return say("Not tested: {}.", section_.inWords(test.reason));
    }
    if (!family.isConfirmatory(test.id) || !test.isSignificant) return say("Exploratory.");
    if (!*test.isSignificant) return say("Not significant.");
    if (!difference) return say("A significant difference.");
    const bool isFirst = *difference > 0.0;
    return say(
        "Significant: {} higher.", section_.conditionTitle(isFirst ? test.group1 : test.group2));
  }

  void addSiteDifferences(const FamilyResult& family) {
    auto table = tableOf(
        family.family.id + "-sites",
        section_.results.families.size() > 1 ? family.family.title + ": " + say("By site")
                                             : say("By site"),
        {words("Cohort"),
         words("Comparison"),
         words("Site"),
         Heading{"n"},
         number("Difference"),
         Heading{say("{:g} % CI", 100.0 * (1.0 - family.family.alpha))},
         Heading{"p"}});
    for (const auto& part : family.cohorts) {
      if (!part.sites) continue;
      for (const auto& pair : part.sites->rows) {
        const auto who = section_.cohortTitle(part.cohort);
        const auto groups =
            section_.conditionTitle(pair.group1) + " vs. " + section_.conditionTitle(pair.group2);
        for (const auto& site : pair.sites) {
          table.rows.push_back(
              {who,
               groups,
               site.site,
               std::to_string(site.test.n),
               orNothing(site.test.meanDifference),
               orNothing(site.interval),
               site.test.p ? formatP(site.test.p) : std::string()});
        }
        const auto together = say("All sites, random effects (REML, Knapp–Hartung)");
        if (!pair.pooled) {
          table.rows.push_back(
              {who,
               groups,
               together,
               "",
               say("not pooled: {}", section_.inWords(pair.reason)),
               "",
               ""});
          continue;
        }
        const auto& pooled = pair.pooled->knappHartung;
        table.rows.push_back(
            {who,
             groups,
             together,
             "",
             orNothing(pooled.estimate),
             orNothing(pooled.interval),
             formatP(pooled.p)});
      }
    }
    add(std::move(table));
  }

  // --- What is compared ---

  void means() {
    auto table = tableOf(
        "means",
        say("Means"),
        {words("Question"),
         words("Cohort"),
         words("Method"),
         Heading{"M"},
         Heading{"s²"},
         number("Answers")});
    for (const auto& family : section_.results.families) {
      for (const auto& part : family.cohorts) {
        for (const auto& one : part.conditions) {
          if (one.answers.total() == 0) continue;
          table.rows.push_back(
              {family.family.title,
               section_.cohortTitle(part.cohort),
               section_.conditionTitle(one.name),
               orNothing(one.answers.mean()),
               orNothing(one.answers.variance()),
               std::to_string(one.answers.total())});
        }
      }
    }
    add(std::move(table));
  }

  /// Each item by itself, as it was answered. A mean of one person would be that person's answer.
  void items() {
    auto table = tableOf(
        "items",
        say("Single items"),
        {words("Question"),
         words("Cohort"),
         words("Method"),
         number("People"),
         Heading{"M"},
         Heading{"SD"},
         number("Median"),
         number("Smallest"),
         number("Largest")});
    for (const auto& one : section_.results.answers.items) {
      const auto* instrument = section_.instrument(one.instrument);
      if (instrument == nullptr || one.values.size() < 2) continue;
      const auto* item = instrument->item(one.item);
      table.rows.push_back(
          {item == nullptr ? one.item : questionOf(*item, section_.words.language()),
           section_.cohortTitle(one.cohort),
           one.condition.empty() ? std::string() : section_.conditionTitle(one.condition),
           std::to_string(one.values.size()),
           orNothing(one.mean),
           orNothing(one.standardDeviation),
           orNothing(one.median),
           orNothing(one.least),
           orNothing(one.most)});
    }
    add(std::move(table));
  }

  void preferences(const VoteTable& votes) {
    auto table = tableOf("preferences", say("Preferences"), {words("Cohort"), words("After")});
    for (const auto& option : votes.options) {
      table.columns.push_back({section_.conditionTitle(option)});
    }
    table.columns.push_back(number("exact p"));
    const auto row = [&](const std::string& who,
                         const std::string& afterBlock,
                         const analysis::VoteCounts& counts,
                         const std::string& p) {
      Cells cells{who, afterBlock};
      for (const auto& share : counts.shares()) cells.push_back(std::to_string(share.votes));
      cells.push_back(p);
      table.rows.push_back(std::move(cells));
    };
    for (const auto& one : votes.cohorts) {
      if (one.sum.total() == 0) continue;
      const auto who = section_.cohortTitle(one.cohort);
      for (const auto* vote : one.rounds) {
        const auto& test = vote->test;
        const auto p = test.exactP ? formatP(test.exactP) : test.p ? "χ²: " + formatP(test.p) : "";
        row(who, section_.blockTitle(vote->block), vote->votes, p);
      }
      if (one.rounds.size() > 1) row(who, say("Sum"), one.sum, {});
    }
    if (table.rows.size() > 1) row(say("Total"), {}, votes.total, {});
    add(std::move(table));
  }

  void scores() {
    auto table = tableOf(
        "scores",
        say("Questionnaires"),
        {words("Score"),
         words("Cohort"),
         words("About"),
         Heading{"n"},
         Heading{"M"},
         Heading{"SD"},
         number("95 % CI")});
    for (const auto& summary : section_.results.instruments) {
      const auto* instrument = section_.instrument(summary.instrument);
      if (instrument == nullptr) continue;
      const auto& language = section_.words.language();
      for (const auto& score : summary.scores) {
        if (score.values.empty()) continue;
        table.rows.push_back(
            {instrument->title.in(language) + ", " +
                 instrument->score(score.score)->title.in(language),
             section_.cohortTitle(score.cohort),
             !score.condition.empty() ? section_.conditionTitle(score.condition)
             : score.occasion.empty() ? std::string()
                                      : say(score.occasion),
             std::to_string(score.values.size()),
             orNothing(score.mean),
             orNothing(score.standardDeviation),
             orNothing(score.interval)});
      }
    }
    add(std::move(table));
  }

  void remarks() {
    auto table = tableOf(
        "remarks",
        say("Remarks"),
        {words("Cohort"), words("Remark"), words("Why it matters"), words("What to do")});
    for (const auto& family : section_.results.families) {
      for (const auto& [flag, found] : flagsByKind(family, isPooled(profile_, family.family))) {
        for (const auto& [cohort, what] : found) {
          std::string sentence;
          for (const auto& piece : what->what) sentence += section_.inWords(piece);
          table.rows.push_back(
              {section_.cohortTitle(cohort),
               sentence,
               section_.words(flag->why),
               section_.words(flag->remedy)});
        }
      }
    }
    add(std::move(table));
  }

  const ReportSection& section_;
  Profile profile_;
  std::vector<DataTable> tables_;
};

}  // namespace

Answer answerInWords(const ReportSection& section) {
  const auto& words = section.words;
  auto answer = conclusionOf(section);
  if (answer.finding.empty()) {
    answer.finding =
        words("Nothing can be compared yet: no completed session has answers to compare.");
  } else if (areAnswersPooled(section)) {
    answer.caveats.push_back(
        words("As the protocol declares, these tests take all answers of a person as "
              "independent: their p may be far too small. The tests within participants "
              "take each person once."));
  }
  return answer;
}

std::vector<DataTable> statisticsTables(const ReportSection& section, Profile profile) {
  return TablesWriter(section, profile).all();
}

}  // namespace study::report
