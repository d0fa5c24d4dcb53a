#include <algorithm>
#include <optional>
#include <set>

#include "study/report/study_parts.h"
#include "study/results/vote_tables.h"

namespace study::report {
namespace {

using Names = std::vector<std::string>;

/// The condition that got most votes.
struct MostNamed {
  std::string condition;
  std::string phase;  ///< one that asked
  std::uint64_t votes = 0;
  std::uint64_t total = 0;
  std::size_t rounds = 0;
};

/// std::nullopt if there are no votes, or several conditions got as many.
std::optional<MostNamed> mostNamedIn(const Results& results) {
  for (const auto& table : voteTables(results)) {
    MostNamed most{.total = table.total.total()};
    if (most.total == 0) continue;
    for (const auto& share : table.total.shares()) most.votes = std::max(most.votes, share.votes);
    Names named;
    for (const auto& share : table.total.shares()) {
      if (share.votes == most.votes) named.push_back(share.option);
    }
    if (named.size() > 1) continue;
    std::set<std::string> rounds;
    for (const auto& cohort : table.cohorts) {
      for (const auto* vote : cohort.rounds) rounds.insert(vote->phase);
    }
    most.condition = named.front();
    most.phase = *rounds.begin();
    most.rounds = rounds.size();
    return most;
  }
  return std::nullopt;
}

/// The best alternative against another one, over the cohorts in which both were tested.
struct Outcome {
  std::string condition;
  std::size_t tested = 0;
  std::size_t above = 0;  ///< cohorts in which the best alternative is significantly higher
  std::size_t below = 0;
  std::size_t testedWithin = 0;       ///< cohorts with a paired test of participants' means
  std::size_t significantWithin = 0;  ///< of these, the tests that agree with the declared one
  Names differences;                  ///< of each cohort, in words
};

/// Says what was found without statistics.
class VerdictWriter {
 public:
  explicit VerdictWriter(const ReportSection& section) : section_(section), words_(section.words) {}

  Conclusion all() {
    const auto alone = words_("One participant so far: nothing can be compared.");
    if (section_.results.completed() == 1) return {.finding = alone, .comparisons = {}};
    const auto named = mostNamedIn(section_.results);
    Conclusion conclusion;
    if (named) conclusion.finding = votes(*named);
    const auto* family = mainFamily(section_);
    if (family == nullptr) return conclusion;
    best_ = bestAlternativeOf(section_);
    if (!named) conclusion.finding = ratings();
    const auto text = comparisons(*family);  // each sentence begins with a space
    if (!text.empty()) conclusion.comparisons = text.substr(1);
    return conclusion;
  }

 private:
  std::string votes(const MostNamed& most) const {
    const auto people = section_.results.completed();
    const auto origin = most.total != static_cast<std::uint64_t>(people) * most.rounds
                            ? words_.say("in {} rounds", most.rounds)
                        : most.rounds == 1
                            ? words_("one vote each")
                            : words_.say("{} people × {} rounds", people, most.rounds);
    const auto asked = questionIn(most.phase);
    const auto title = section_.introducedTitle(most.condition);
    const auto resembled = words_.say(
        "{} got {} of {} votes of {} participants for resembling the real tool most ({}).",
        title,
        most.votes,
        most.total,
        people,
        origin);
    const auto answered = words_.say(
        "Asked “{}”, {} participants named {} most often: {} of {} votes ({}).",
        asked == nullptr ? std::string() : questionOf(*asked, words_.language()),
        people,
        title,
        most.votes,
        most.total,
        origin);
    const bool isOfRealTool =
        asked != nullptr && asked->refersTo == questionnaires::Referent::Benchmark;
    return isOfRealTool ? resembled : answered;
  }

  /// The question of a preference; nullptr if its instrument has none about alternatives.
  const questionnaires::Item* questionIn(const std::string& phase) const {
    const auto& phases = section_.protocol.phases;
    const auto asks = std::ranges::find(phases, phase, &protocols::Phase::id);
    if (asks == phases.end()) return nullptr;
    for (const auto& instrument : section_.instruments) {
      if (instrument.id != asks->instrument) continue;
      for (const auto& item : instrument.items) {
        if (item.optionSource == questionnaires::OptionSource::Alternatives) return &item;
      }
    }
    return nullptr;
  }

  std::string ratings() const {
    return words_.say(
        "{} participants rated {} highest.",
        section_.results.completed(),
        section_.introducedTitle(best_));
  }

  /// Whether the ratings of the best alternative differ from those of the others.
  std::string comparisons(const FamilyResult& family) const {
    if (!family.isDeclared) return " " + words_("All comparisons are exploratory.");
    std::vector<Outcome> higher;
    std::vector<Outcome> lower;
    std::vector<Outcome> alike;
    std::string mixed;
    const auto untested = words_("Whether cohorts differ in this was not tested.");
    for (const auto& condition : section_.protocol.conditions) {
      const auto one = outcomeOf(family, condition.id);
      if (one.tested == 0) continue;
      if (one.above == one.tested) {
        higher.push_back(one);
      } else if (one.below == one.tested) {
        lower.push_back(one);
      } else if (one.above + one.below == 0) {
        alike.push_back(one);
      } else {
        mixed += " " + words_.say(
                           "Its rating differs from that of {} by {}.",
                           section_.introducedTitle(condition.id),
                           listed(one.differences, words_));
      }
    }
    const bool isPooled = family.isNamed("welch");
    return significant(
               isPooled ? "By the declared test, which takes all answers as independent, it was "
                          "rated significantly higher than {}{}."
                        : "It was rated significantly higher than {}{}.",
               higher,
               isPooled) +
           significant(
               isPooled ? "By the declared test, which takes all answers as independent, it was "
                          "rated significantly lower than {}{}."
                        : "It was rated significantly lower than {}{}.",
               lower,
               isPooled) +
           (mixed.empty() ? mixed : mixed + " " + untested) +
           significant("Its rating does not differ significantly from that of {}{}.", alike, false);
  }

  /// @param isPooled  whether to say what comparing within people finds
  std::string significant(
      std::string_view english, const std::vector<Outcome>& outcomes, bool isPooled) const {
    Names titles;
    for (const auto& one : outcomes) titles.push_back(section_.introducedTitle(one.condition));
    const auto sentence = words_.say(
        english, listed(titles, words_), isPooled ? withinPeople(outcomes) : std::string());
    return outcomes.empty() ? std::string() : " " + sentence;
  }

  /// What the tests within people find of differences that the pooled test found.
  std::string withinPeople(const std::vector<Outcome>& outcomes) const {
    Names all;
    Names none;
    Names untested;
    Names some;
    for (const auto& one : outcomes) {
      const auto& title = section_.conditionTitle(one.condition);
      const auto counted = words_.say(
          "significant for {} in {} of {} cohorts", title, one.significantWithin, one.tested);
      auto& names = one.testedWithin == 0                 ? untested
                    : one.significantWithin == 0          ? none
                    : one.significantWithin == one.tested ? all
                                                          : some;
      names.push_back(&names == &some ? counted : title);
    }
    std::string text;
    const auto add = [&](const std::string& clause, const Names& names) {
      if (!names.empty()) text += (text.empty() ? "" : ", ") + clause;
    };
    add(words_.say("significant for {}", listed(all, words_)), all);
    add(listed(some, words_), some);
    add(words_.say("not significant for {}", listed(none, words_)), none);
    add(words_.say("not testable for {}", listed(untested, words_)), untested);
    return words_.say("; compared within people, this is {}", text);
  }

  Outcome outcomeOf(const FamilyResult& family, const std::string& other) const {
    Outcome outcome{.condition = other};
    for (const auto& part : family.cohorts) {
      for (const auto& row : declaredIn(family, part)) {
        if (other == best_ || !row.has(best_) || !row.has(other) || !row.isDefined()) continue;
        const double sign = row.group1 == best_ ? 1.0 : -1.0;
        const double difference = sign * *row.difference->estimate.value;
        const bool isSignificant = row.test->isSignificant.value_or(false);
        const auto& within = *row.withinPeople;
        const bool agrees = within.p && within.isSignificant.value_or(false) &&
                            sign * within.estimate.value.value_or(0.0) * difference > 0.0;
        ++outcome.tested;
        if (isSignificant) ++(difference > 0.0 ? outcome.above : outcome.below);
        if (within.p) ++outcome.testedWithin;
        if (agrees) ++outcome.significantWithin;
        const auto points = rounded(difference, 2);
        const auto& who = section_.cohortTitle(part.cohort);
        const auto plain = words_.say("{} points ({})", points, who);
        const auto clear = words_.say("{} points ({}, significant)", points, who);
        const auto pooled =
            words_.say("{} points ({}, significant of pooled answers only)", points, who);
        outcome.differences.push_back(
            !isSignificant                       ? plain
            : agrees || !family.isNamed("welch") ? clear
                                                 : pooled);
      }
    }
    return outcome;
  }

  const ReportSection& section_;
  const words::Words& words_;
  std::string best_;  ///< condition
};

}  // namespace

std::string highestRatedIn(const FamilyResult& family) {
  std::string best;
  for (const auto& part : family.cohorts) {
    for (const auto& one : part.conditions) {
      const auto mean = meanOfAll(family, one.name);
      if (mean && (best.empty() || *mean > *meanOfAll(family, best))) best = one.name;
    }
  }
  return best;
}

std::string bestAlternativeOf(const ReportSection& section) {
  if (const auto named = mostNamedIn(section.results)) return named->condition;
  const auto* family = mainFamily(section);
  return family == nullptr ? std::string() : highestRatedIn(*family);
}

Conclusion conclusionOf(const ReportSection& section) {
  return VerdictWriter(section).all();
}

std::string verdictOf(const ReportSection& section) {
  const auto verdict = conclusionOf(section);
  return verdict.finding + (verdict.comparisons.empty() ? "" : " ") + verdict.comparisons;
}

}  // namespace study::report
