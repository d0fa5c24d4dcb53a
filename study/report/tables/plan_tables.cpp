#include "study/report/tables/plan_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "analysis/planning/power.h"
#include "base/joined.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"
#include "study/results/results.h"

namespace study::report {
namespace {

std::string percent(double share) {
  return fmt::format("{:.0f}\u00a0%", 100.0 * share);
}

std::string asCell(const std::optional<std::uint64_t>& number) {
  return number ? std::to_string(*number) : "> 1 000 000";
}

class PlanWriter {
 public:
  PlanWriter(const StudyPlan& plan, const words::Words& words) : plan_(plan), words_(words) {}

  Answer answer() const {
    Answer answer;
    std::set<std::string> caveats;
    const auto caveat = [&](std::string sentence) {
      if (caveats.insert(sentence).second) answer.caveats.push_back(std::move(sentence));
    };
    std::vector<std::string> lines;
    if (plan_.families.empty()) {
      lines.push_back(
          words_("The protocol declares no comparisons, so there is no power to compute."));
    }
    for (const auto& family : plan_.families) {
      const auto title =
          plan_.families.size() > 1 ? words_.say("“{}”", family.title) + ": " : std::string();
      const auto declared = ofDeclaredTest(family);
      lines.push_back(title + declared + (declared.empty() ? "" : " ") + needed(family));
      if (isAnyCohortTooSmall(family)) {
        caveat(words_.say(
            "With fewer than {} participants, no exact paired test can be significant at α = {}.",
            family.fewestForSignificance,
            rounded(family.levels.mostLenient, 4)));
      }
      const auto wrong = falsePositives(family);
      if (!wrong.empty()) caveat(wrong);
      caveat(words_.say(
          "Power is that of a paired t-test of people’s means at α = {}.",
          rounded(family.levels.strictest, 4)));
    }
    const auto balance = ordersInWords();
    if (!balance.empty()) lines.push_back(balance);
    lines.push_back(
        words_.say("A session lasts about {} minutes.", minutesOf(plan_.length.seconds)));
    answer.finding = base::joined(lines, "\n");
    return answer;
  }

  std::vector<DataTable> tables() {
    for (const auto& family : plan_.families) power(family);
    cohorts();
    orders();
    session();
    preferences();
    auto& ethics = add("ethics", words_("For an ethics committee"), {words("Paragraph")});
    ethics.rows.push_back({ethicsParagraph(plan_)});
    std::erase_if(tables_, [](const auto& table) { return table.rows.empty(); });
    return std::move(tables_);
  }

 private:
  // --- Sentences ---

  /// What each cohort has, each number of participants once.
  static std::map<std::uint64_t, const Detectability*> byParticipants(const FamilyPlan& family) {
    std::map<std::uint64_t, const Detectability*> found;
    for (const auto& cohort : family.detectabilities) {
      if (cohort.power) found.try_emplace(cohort.participants, &cohort);
    }
    return found;
  }

  static bool isAnyCohortTooSmall(const FamilyPlan& family) {
    return std::ranges::any_of(family.detectabilities, [](const auto& cohort) {
      return cohort.power && !cohort.canPairsBeSignificant;
    });
  }

  std::string needed(const FamilyPlan& family) const {
    auto text = words_.say(
        "By a paired t-test, {} participants in a cohort find a difference of d_z = {:g} with a "
        "probability of {}",
        asCell(family.sampleSizeForPower),
        plan_.planOptions.dz,
        percent(plan_.planOptions.power));
    const auto planned = byParticipants(family);
    for (const auto& [participants, cohort] : planned) {
      text += words_.say("; {} find it with {}", participants, percent(*cohort->power));
    }
    if (family.recommended && plan_.balancedBy > 1) {
      text += words_.say("; {} balance the orders as well", *family.recommended);
    }
    text += ".";
    if (planned.empty()) {
      text += " " + words_(
                        "The protocol does not say how many participants will come: enter "
                        "a number.");
    }
    return text;
  }

  /// The declared test, and how often it finds the difference in simulated studies; empty for a
  /// paired t-test.
  std::string ofDeclaredTest(const FamilyPlan& family) const {
    if (family.test == protocols::TestType::PairedT) return {};
    std::vector<std::string> shares;
    for (const auto& [participants, cohort] : byParticipants(family)) {
      if (!cohort->found) continue;
      shares.push_back(simulatedShare(participants, rateOf(family.test, *cohort->found)));
    }
    if (family.foundIfRecommended && !byParticipants(family).contains(*family.recommended)) {
      shares.push_back(simulatedShare(*family.recommended, *family.foundIfRecommended));
    }
    const auto test = words_(shortNameOf(idOf(family.test)));
    const auto named = words_.say("The protocol declares another test: {}.", test);
    const auto found = words_.say(
        "In simulated studies, the declared test ({}) finds a difference of d_z = {:g}: {}.",
        test,
        plan_.planOptions.dz,
        base::joined(shares, ", "));
    return shares.empty() ? named : found;
  }

  std::string simulatedShare(
      std::uint64_t participants, const analysis::DetectionRate& detection) const {
    return words_.say("{} participants {}", participants, percent(detection.rate));
  }

  /// How often Welch's test of single answers finds what is not there; empty for another test.
  std::string falsePositives(const FamilyPlan& family) const {
    if (family.test != protocols::TestType::Welch) return {};
    for (const auto& [participants, cohort] : byParticipants(family)) {
      if (!cohort->falsePositives) continue;
      return words_.say(
          "Welch’s t takes every answer as if another person had given it: with {} participants, "
          "it "
          "calls some methods different in {} of simulated studies in which none are.",
          participants,
          percent(cohort->falsePositives->anyPooledWelch.rate));
    }
    return {};
  }

  std::string ordersInWords() const {
    std::size_t blocks = 0;
    std::size_t fixed = 0;
    std::size_t drawn = 0;
    for (const auto& block : plan_.blocks) {
      if (block.conditions < 2) continue;
      ++blocks;
      if (block.hasOneOrder) ++fixed;
      if (block.multipleOf == 0) ++drawn;
    }
    if (blocks == 0) return {};
    if (fixed == blocks) {
      return words_("All participants have the same order: no number of them balances it.");
    }
    if (drawn == blocks)
      return words_("Orders are drawn for each participant: balanced on average.");
    if (fixed + drawn > 0) return words_("Not every block can be balanced: see “Orders”.");
    return words_.say(
        "Orders are balanced for every multiple of {} participants.", plan_.balancedBy);
  }

  // --- Tables ---

  /// The heading of a column of words, which may begin with a title of the protocol.
  Heading words(std::string_view english) const { return Heading::ofWords(words_(english)); }
  Heading number(std::string_view english) const { return {words_(english)}; }

  DataTable& add(std::string name, std::string title, std::vector<Heading> headings) {
    return tables_.emplace_back(DataTable{
        .name = std::move(name), .description = std::move(title), .columns = std::move(headings)});
  }

  void power(const FamilyPlan& family) {
    const auto effects = effectsToShow(plan_);
    std::vector<Heading> headings{words("Participants in a cohort")};
    for (const double dz : effects) headings.push_back({fmt::format("d_z = {:g}", dz)});
    const auto title =
        plan_.families.size() > 1 ? words_("Power") + ": " + family.title : words_("Power");
    auto& table = add("power-" + family.id, title, std::move(headings));
    for (const auto n : sizesToShow(family)) {
      std::vector<Cell> cells{std::to_string(n)};
      for (const double dz : effects) {
        cells.emplace_back(percent(analysis::pairedTPower(dz, n, family.levels.strictest)));
      }
      table.rows.push_back(std::move(cells));
    }
    std::vector<Cell> needed{words_.say("needed for {}", percent(plan_.planOptions.power))};
    for (const double dz : effects) {
      needed.emplace_back(asCell(
          analysis::participantsForPower(dz, family.levels.strictest, plan_.planOptions.power)));
    }
    table.rows.push_back(std::move(needed));
  }

  void cohorts() {
    auto& table =
        add("cohorts",
            words_("Cohorts"),
            {words("Question"),
             words("Cohort"),
             Heading{"n"},
             number("Power"),
             number("Power, simulated"),
             number("Found without a difference, simulated"),
             number("Smallest exact p"),
             words("In words")});
    for (const auto& family : plan_.families) {
      for (std::size_t i = 0; i < plan_.cohorts.size(); ++i) {
        const auto& cohort = family.detectabilities[i];
        if (cohort.participants == 0) continue;
        table.rows.push_back(
            {family.title,
             plan_.cohorts[i].title,
             std::to_string(cohort.participants),
             cohort.power ? percent(*cohort.power) : std::string(),
             cohort.found ? percent(cohort.found->pairedT.rate) : std::string(),
             cohort.falsePositives ? percent(cohort.falsePositives->anyPairedT.rate)
                                   : std::string(),
             formatP(cohort.pair.p),
             words_(
                 cohort.canPairsBeSignificant ? "Exact paired tests can be significant."
                                              : "No exact paired test can be significant.")});
      }
    }
  }

  void orders() {
    auto& table =
        add("orders", words_("Orders"), {words("Block"), number("Methods"), words("In words")});
    for (const auto& block : plan_.blocks) {
      table.rows.push_back({block.phase, std::to_string(block.conditions), balanceOf(block)});
    }
    for (const auto& cohort : plan_.cohorts) {
      if (plan_.balancedBy < 2 || cohort.participants == 0) continue;
      table.rows.push_back(
          {cohort.title,
           std::string(),
           cohort.isBalanced
               ? words_.say("{} participants balance every block.", cohort.participants)
               : words_.say(
                     "{} participants do not balance every block: a multiple of {} does.",
                     cohort.participants,
                     plan_.balancedBy)});
    }
  }

  std::string balanceOf(const BlockPlan& block) const {
    if (block.conditions < 2) return words_("Nothing to balance.");
    if (block.hasOneOrder) {
      return words_(
          "All have the same order: what is felt later may seem better or worse for that alone.");
    }
    if (block.multipleOf == 0) {
      return words_("An order is drawn for each participant: balanced on average only.");
    }
    return words_.say("Balanced for every multiple of {} participants.", block.multipleOf);
  }

  void session() {
    auto& table =
        add("session",
            words_("Length of a session"),
            {words("Part"), number("Minutes"), number("Steps"), number("Items"), number("Cuts")});
    const auto orNothing = [](auto number) {
      return number > 0 ? std::to_string(number) : std::string();
    };
    for (const auto& part : plan_.length.parts) {
      table.rows.push_back(
          {words_(partInWords(part.kind)),
           fmt::format("{:.1f}", part.seconds / 60.0),
           std::to_string(part.steps),
           orNothing(part.items),
           orNothing(part.cuts)});
    }
    if (table.rows.empty()) return;
    table.rows.push_back(
        {words_("Total"),
         std::to_string(minutesOf(plan_.length.seconds)),
         std::string(),
         std::string(),
         std::string()});
  }

  void preferences() {
    auto& table =
        add("preferences",
            words_("Preferences"),
            {words("After"),
             words("Cohort"),
             number("Alternatives"),
             number("Votes"),
             number("Votes for one that are significant")});
    for (const auto& vote : plan_.votes) {
      if (vote.votes == 0 || vote.alternatives < 2) continue;
      table.rows.push_back(
          {vote.phase,
           vote.cohort,
           std::to_string(vote.alternatives),
           std::to_string(vote.votes),
           vote.votesForSignificance ? std::to_string(*vote.votesForSignificance)
           : vote.canDecide          ? std::string()
                                     : words_("too few, even if all agree")});
    }
  }

  const StudyPlan& plan_;
  const words::Words& words_;
  std::vector<DataTable> tables_;
};

}  // namespace

Answer planInWords(const StudyPlan& plan, const words::Words& words) {
  return PlanWriter(plan, words).answer();
}

std::vector<DataTable> planTables(const StudyPlan& plan, const words::Words& words) {
  return PlanWriter(plan, words).tables();
}

}  // namespace study::report
