#include <algorithm>
#include <cmath>
#include <iterator>
#include <map>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "base/joined.h"
#include "study/report/html_text.h"
#include "study/report/study_parts.h"
#include "study/results/apa_text.h"
#include "study/results/vote_tables.h"

namespace study::report {
namespace {

using Names = std::vector<std::string>;

/// Two forms of a sentence on what the declared test found: `first` begins a text and names the
/// test, `next` follows it.
struct Finding {
  std::string_view first;
  std::string_view next;
};

constexpr Finding kHigher{
    "By the declared test ({}), {} was rated significantly higher than {}.",
    "{} was rated significantly higher than {}."};
constexpr Finding kLower{
    "By the declared test ({}), {} was rated significantly lower than {}.",
    "{} was rated significantly lower than {}."};
constexpr Finding kAlike{
    "By the declared test ({}), {} was rated neither significantly higher nor lower than {}{}.",
    "{} was rated neither significantly higher nor lower than {}{}."};

/// The best alternative against another one, over the cohorts in which both were tested.
struct Outcome {
  std::string condition;
  std::size_t testedCohorts = 0;
  std::size_t significantlyHigher =
      0;  ///< cohorts in which the best alternative is significantly higher
  std::size_t significantlyLower = 0;
  std::size_t testedWithin = 0;       ///< cohorts with a paired test of participants' means
  std::size_t significantWithin = 0;  ///< of the significant ones, those in which it agrees
  std::size_t negligible = 0;         ///< cohorts in which it is smaller than the family's bound
  std::vector<double> points;         ///< of each cohort, above 0 where the best one is higher
  std::size_t mostPeople = 0;         ///< who were compared in a cohort

  std::size_t significant() const { return significantlyHigher + significantlyLower; }
  /// Whether cohorts differ in what was found.
  bool isMixed() const {
    return significant() > 0 && significantlyHigher < testedCohorts &&
           significantlyLower < testedCohorts;
  }
};

/// Says what was found without statistics.
class VerdictWriter {
 public:
  explicit VerdictWriter(const ReportSection& section) : section_(section), words_(section.words) {}

  Answer all() {
    const auto alone = words_("One participant so far: nothing can be compared.");
    if (section_.results.completed() == 1) return {.finding = alone};
    const auto* family = mainFamily(section_);
    if (family != nullptr) {
      best_ = highestRatedIn(*family);
      const bool isTested = family->isDeclared && !testedIn(*family).empty();
      if (!isTested) headline_.push_back(ratings(*family));
      comparisons(*family);
      if (section_.results.families.size() > 1 && !headline_.empty()) {
        headline_.front() = words_.say("“{}”", family->family.title) + ": " + headline_.front();
      }
      otherFamilies(*family);
    }
    if (const auto named = mostNamedIn(section_.results)) votes(*named);
    if (headline_.empty()) headline_.swap(more_);
    return {
        .finding = withCurlyQuotes(base::joined(headline_, " ")),
        .more = withCurlyQuotes(base::joined(more_, " "))};
  }

 private:
  void votes(const MostNamed& most) {
    const auto people = section_.results.completed();
    const auto origin = most.total != static_cast<std::uint64_t>(people) * most.rounds
                            ? words_.say("in {} rounds", most.rounds)
                        : most.rounds == 1
                            ? words_("one vote each")
                            : words_.say("{} people × {} rounds", people, most.rounds);
    headline_.push_back(words_.say(
        "{} was named most often: {} of {} votes ({}; exploratory{}).",
        introduced(most.condition),
        most.votes,
        most.total,
        origin,
        isAnyVoteSignificant() ? std::string() : "; " + votesAreNotSignificant()));
    const auto* asked = questionIn(most.phase);
    if (asked == nullptr) return;
    more_.push_back(words_.say("The votes answer “{}”", questionOf(*asked, words_.language())));
  }

  /// Whether votes of a cohort in a round differ significantly from equal shares, or none is
  /// tested.
  bool isAnyVoteSignificant() const {
    constexpr double kAlpha = 0.05;
    const auto& all = section_.results.votes;
    const auto pOf = [](const VoteResult& vote) {
      return vote.test.exactP ? vote.test.exactP : vote.test.p;
    };
    const auto isTested = [&](const auto& vote) { return pOf(vote).has_value(); };
    return std::ranges::none_of(all, isTested) || std::ranges::any_of(all, [&](const auto& vote) {
             return pOf(vote).value_or(1.0) <= kAlpha;
           });
  }

  std::string votesAreNotSignificant() const {
    const auto inAny = words_("not significant in any cohort");
    const auto inOne = words_("not significant");
    return hasOneCohort() ? inOne : inAny;
  }

  /// Whether people of one cohort only completed.
  bool hasOneCohort() const {
    return std::ranges::count_if(
               section_.results.flow, [](const auto& flow) { return flow.completed > 0; }) == 1;
  }

  /// The question of a preference; nullptr if its instrument has none about alternatives.
  const questionnaires::Item* questionIn(const std::string& phase) const {
    const auto& phases = section_.protocol.phases;
    const auto asks = std::ranges::find(phases, phase, &protocols::Phase::id);
    if (asks == phases.end()) return nullptr;
    const auto* instrument = section_.instrument(asks->instrument);
    if (instrument == nullptr) return nullptr;
    const auto item = std::ranges::find(
        instrument->items,
        questionnaires::OptionSource::Alternatives,
        &questionnaires::Item::optionSource);
    return item == instrument->items.end() ? nullptr : &*item;
  }

  /// Which mean of all answers is the highest, of a family that is not tested.
  std::string ratings(const FamilyResult& family) {
    const auto people = section_.results.completed();
    const bool isTied = std::ranges::any_of(section_.protocol.conditions, [&](const auto& other) {
      return other.id != best_ && meanOfAll(family, other.id) == meanOfAll(family, best_);
    });
    const auto tied = words_.say(
        "On average no method was rated higher than all others ({} participants).", people);
    const auto highest =
        words_.say("On average {} was rated highest ({} participants).", introduced(best_), people);
    return isTied ? tied : highest;
  }

  /// Why the declared test of a family has no result in any cohort, if a reason is known.
  void notTested(const FamilyResult& family) {
    for (const auto& part : family.cohorts) {
      for (const auto& row : declaredIn(family, part)) {
        if (row.test->reason.empty()) continue;
        headline_.push_back(words_.say(
            "By the declared test ({}), nothing can be compared: {}.",
            testInWords(family.family.test, words_),
            words_(row.test->reason)));
        return;
      }
    }
  }

  /// How many differences of the declared families other than @p main are significant.
  void otherFamilies(const FamilyResult& main) {
    Names counts;
    for (const auto& family : section_.results.families) {
      if (&family == &main || !family.isDeclared) continue;
      const auto tested = testedIn(family);
      const auto significant = std::ranges::count_if(
          tested, [](const auto& row) { return row.test->isSignificant.value_or(false); });
      const auto counted =
          words_.say("{} of {} in “{}”", significant, tested.size(), family.family.title);
      const auto nothing = words_.say("none tested in “{}”", family.family.title);
      const auto pooled = " (" + words_("all answers pooled") + ")";
      counts.push_back(
          tested.empty()            ? nothing
          : family.isNamed("welch") ? counted + pooled
                                    : counted);
    }
    if (counts.empty()) return;
    more_.push_back(words_.say("Significant differences otherwise: {}.", listed(counts, words_)));
    for (const auto& family : section_.results.families) {
      if (&family == &main || !family.isDeclared) continue;
      const auto small = negligible(family);
      if (!small.empty()) {
        more_.push_back(words_.say("“{}”", family.family.title) + ": " + small);
      }
    }
  }

  /// Whether the ratings of the best alternative differ from those of the others.
  void comparisons(const FamilyResult& family) {
    if (!family.isDeclared) {
      headline_.push_back(words_("All comparisons are exploratory."));
      return;
    }
    if (testedIn(family).empty()) return notTested(family);
    test_ = testInWords(family.family.test, words_);
    std::vector<Outcome> found;
    std::vector<Outcome> alike;
    for (const auto& condition : section_.protocol.conditions) {
      const auto one = outcomeOf(family, condition.id);
      if (one.testedCohorts > 0) (one.significant() > 0 ? found : alike).push_back(one);
    }
    say(kHigher, found, &Outcome::significantlyHigher);
    say(kLower, found, &Outcome::significantlyLower);
    if (!found.empty() && family.isNamed("welch")) headline_.push_back(withinPeople(found));
    const auto untested = words_("Whether cohorts differ in these differences was not tested.");
    if (std::ranges::any_of(found, &Outcome::isMixed)) more_.push_back(untested);
    auto& others = found.empty() ? headline_ : more_;
    if (!alike.empty() && isNothingSignificant(family)) {
      headline_.push_back(nothingSignificant(family));
      if (isHighestInEach(family)) more_.push_back(highest(family));
    } else if (!alike.empty()) {
      others.push_back(neither(alike));
      const bool isAnyUnknown = std::ranges::any_of(
          alike, [](const auto& one) { return one.negligible < one.testedCohorts; });
      if (isAnyUnknown) others.push_back(sizesOf(family, alike));
    }
    if (auto small = negligible(family); !small.empty()) headline_.push_back(std::move(small));
    std::ranges::move(otherDifferences(family, !found.empty()), std::back_inserter(others));
  }

  /// The significant differences between alternatives other than the best one.
  /// @param isAnySaid  whether a significant difference of the best one was said
  Names otherDifferences(const FamilyResult& family, bool isAnySaid) const {
    struct Cohorts {
      Names all;
      Names pooledOnly;  ///< whose difference the paired t-test does not find
    };
    std::map<std::pair<std::string, std::string>, Cohorts> pairs;  // the higher, and the lower
    for (const auto& part : family.cohorts) {
      for (const auto& row : declaredIn(family, part)) {
        if (row.has(best_) || !row.isDefined() || !row.test->isSignificant.value_or(false))
          continue;
        const double difference = *row.difference->estimate.value;
        auto& cohorts = pairs
            [difference > 0.0 ? std::pair(row.group1, row.group2)
                              : std::pair(row.group2, row.group1)];
        cohorts.all.push_back(section_.cohortTitle(part.cohort));
        if (family.isNamed("welch") && !agreesWithin(row, difference)) {
          cohorts.pooledOnly.push_back(cohorts.all.back());
        }
      }
    }
    if (pairs.size() > 1) {      // a list would push the figure off the first page
      if (isAnySaid) return {};  // the sentences on each cohort count them
      return {words_.say(
          "{} pairs of other methods differ significantly: see the table.", pairs.size())};
    }
    Names sentences;
    for (const auto& [pair, cohorts] : pairs) {
      if (hasOneCohort() && cohorts.pooledOnly.empty()) {
        sentences.push_back(words_.say(
            kHigher.next,
            section_.conditionTitle(pair.first),
            section_.conditionTitle(pair.second)));
        continue;
      }
      const auto where = listed(cohorts.all, words_);
      const auto pooled =
          words_.say("{}, not by the paired t-test", listed(cohorts.pooledOnly, words_));
      sentences.push_back(words_.say(
          "{} was rated significantly higher than {} ({}).",
          section_.conditionTitle(pair.first),
          section_.conditionTitle(pair.second),
          cohorts.pooledOnly.empty()                        ? where
          : cohorts.pooledOnly.size() == cohorts.all.size() ? pooled
                                                            : where + "; " + pooled));
    }
    return sentences;
  }

  /// Whether the paired t-test finds a significant @p difference of the same sign.
  static bool agreesWithin(const Declared& row, double difference) {
    const auto& within = *row.withinPeople;
    return within.p && within.isSignificant.value_or(false) &&
           within.estimate.value.value_or(0.0) * difference > 0.0;
  }

  /// The declared comparisons of a family that were tested, in all cohorts.
  static std::vector<Declared> testedIn(const FamilyResult& family) {
    std::vector<Declared> all;
    for (const auto& part : family.cohorts) {
      for (const auto& row : declaredIn(family, part)) {
        if (row.isDefined()) all.push_back(row);
      }
    }
    return all;
  }

  static bool isNothingSignificant(const FamilyResult& family) {
    return std::ranges::none_of(
        testedIn(family), [](const auto& row) { return row.test->isSignificant.value_or(false); });
  }

  static bool isTested(const FamilyResult& family, const CohortResult& part) {
    return std::ranges::any_of(declaredIn(family, part), &Declared::isDefined);
  }

  /// What was not found, how large the differences are, and of how many people.
  std::string nothingSignificant(const FamilyResult& family) const {
    std::vector<double> points;
    for (const auto& row : testedIn(family)) {
      points.push_back(std::abs(*row.difference->estimate.value));
    }
    std::set<std::pair<std::string, std::string>> pairs;
    for (const auto& row : testedIn(family)) pairs.insert({row.group1, row.group2});
    const auto cohorts = std::ranges::count_if(
        family.cohorts, [&](const auto& part) { return isTested(family, part); });
    const auto where = cohorts > 1 ? " " + words_("in any cohort") : std::string();
    const auto who = peopleIn(family);
    const auto found = words_.count(
        pairs.size(),
        "By the declared test ({1}), the difference ({2}) was not significant{3} ({4}).",
        "By the declared test ({1}), none of the {0} differences ({2}) was significant{3} ({4}).",
        test_,
        sizesOf(family, points),
        where,
        who);
    const auto unknown = words_.count(
        pairs.size(),
        "That does not show that both are alike.",
        "That does not show that they are alike.");
    const bool areAllSmall = std::ranges::all_of(
        testedIn(family), [&](const auto& row) { return isNegligible(family, row); });
    return areAllSmall ? found : found + " " + unknown;
  }

  /// Whether the difference is smaller than the bound that the family declares.
  static bool isNegligible(const FamilyResult& family, const Declared& row) {
    return row.equivalenceP.value_or(1.0) <= family.family.alpha;
  }

  /// Which differences are smaller than the declared bound; empty without one.
  std::string negligible(const FamilyResult& family) const {
    constexpr std::size_t kFew = 3;
    std::size_t tested = 0;
    Names pairs;
    for (const auto& part : family.cohorts) {
      for (const auto& row : declaredIn(family, part)) {
        if (!row.isDefined() || !row.equivalenceP) continue;
        ++tested;
        if (!isNegligible(family, row)) continue;
        const auto pair = words_.say(
            "{} and {}", section_.conditionTitle(row.group1), section_.conditionTitle(row.group2));
        pairs.push_back(
            hasOneCohort() ? pair : pair + " (" + section_.cohortTitle(part.cohort) + ")");
      }
    }
    const auto bound = withUnit(
        section_, family.family, fmt::format("{:g}", family.family.equivalenceBound.value_or(0.0)));
    const auto alpha = fmt::format("{:g}", family.family.alpha);
    const auto some = words_.say(
        "Negligible as declared, smaller than {} (TOST, p ≤ {}): {}.",
        bound,
        alpha,
        base::joined(pairs, ", "));
    const auto many = words_.say(
        "Negligible as declared, smaller than {} (TOST, p ≤ {}): {} of {} differences.",
        bound,
        alpha,
        pairs.size(),
        tested);
    return pairs.empty() ? std::string() : pairs.size() > kFew ? many : some;
  }

  /// "0.41 to 2.42 points".
  std::string sizesOf(const FamilyResult& family, const std::vector<double>& points) const {
    const auto [least, most] = std::ranges::minmax(points);
    const auto first = rounded(least, 2);
    const auto last = rounded(most, 2);
    const auto size = withUnit(section_, family.family, last);
    const auto range = words_.say("{} to {}", first, size);
    return first == last ? size : range;
  }

  /// "4 people each, 8 planned": of the comparisons that were tested.
  std::string peopleIn(const FamilyResult& family) const {
    std::set<std::size_t> counts;
    std::set<std::size_t> planned;
    std::size_t cohorts = 0;
    for (const auto& part : family.cohorts) {
      if (!isTested(family, part)) continue;
      ++cohorts;
      const auto [fewest, most] = peopleComparedIn(family, part);
      counts.insert({fewest, most});
      const auto* cohort = section_.protocol.cohort(part.cohort);
      planned.insert(cohort == nullptr ? 0U : static_cast<std::size_t>(cohort->planned));
    }
    const auto alone = words_.say("{} people", *counts.rbegin());
    const auto same = words_.say("{} people each", *counts.rbegin());
    const auto range = words_.say("{} to {} people each", *counts.begin(), *counts.rbegin());
    const auto ofPlan = ", " + words_.say("{} planned", *planned.rbegin());
    const bool isFewer = planned.size() == 1 && *planned.begin() > *counts.rbegin();
    return (counts.size() > 1 ? range
            : cohorts == 1    ? alone
                              : same) +
           (isFewer ? ofPlan : std::string());
  }

  /// Whether the best alternative has the highest mean of answers in each cohort that was tested.
  bool isHighestInEach(const FamilyResult& family) const {
    return std::ranges::all_of(family.cohorts, [&](const auto& part) {
      const auto own = std::ranges::find(part.conditions, best_, &analysis::NamedSample::name);
      if (!isTested(family, part)) return true;
      return own != part.conditions.end() &&
             std::ranges::none_of(part.conditions, [&](const auto& other) {
               return other.answers.mean() > own->answers.mean();
             });
    });
  }

  std::string highest(const FamilyResult& family) const {
    const auto& title = section_.conditionTitle(best_);
    const bool isOfSeveral = std::ranges::count_if(family.cohorts, [&](const auto& part) {
                               return isTested(family, part);
                             }) > 1;
    return isOfSeveral ? words_.say("{} was rated highest in each cohort.", title)
                       : words_.say("{} was rated highest.", title);
  }

  /// What differences that are not significant do not show.
  std::string sizesOf(const FamilyResult& family, const std::vector<Outcome>& outcomes) const {
    std::vector<double> points;
    std::size_t mostPeople = 0;
    for (const auto& one : outcomes) {
      points.insert(points.end(), one.points.begin(), one.points.end());
      mostPeople = std::max(mostPeople, one.mostPeople);
    }
    return words_.say(
        "That does not show that they are alike ({}, at most {} people).",
        sizesOf(family, points),
        mostPeople);
  }

  /// "FEM in each cohort and KF in 1 of 2 cohorts", or "FEM" where there is only one cohort.
  std::string where(
      const std::vector<Outcome>& outcomes, std::size_t Outcome::*count, bool introduces) {
    std::vector<std::pair<std::pair<std::size_t, std::size_t>, Names>> groups;  // cohorts, titles
    for (const auto& one : outcomes) {
      const std::pair cohorts(one.*count, one.testedCohorts);
      auto same = std::ranges::find(groups, cohorts, [](const auto& group) { return group.first; });
      if (same == groups.end()) same = groups.insert(same, {cohorts, {}});
      same->second.push_back(
          introduces ? introduced(one.condition) : section_.conditionTitle(one.condition));
    }
    Names places;
    for (const auto& [cohorts, names] : groups) {
      const auto titles = listed(names, words_);
      const auto some = words_.say("{} in {} of {} cohorts", titles, cohorts.first, cohorts.second);
      places.push_back(
          cohorts.second == 1              ? titles
          : cohorts.first < cohorts.second ? some
                                           : titles + " " + words_("in each cohort"));
    }
    return listed(places, words_);
  }

  /// Says from which of the others the best alternative differs significantly in this direction.
  void say(
      const Finding& finding, const std::vector<Outcome>& outcomes, std::size_t Outcome::*count) {
    std::vector<Outcome> found;
    std::ranges::copy_if(
        outcomes, std::back_inserter(found), [&](const auto& one) { return one.*count > 0; });
    if (found.empty()) return;
    const auto best = introduced(best_);
    const auto others = where(found, count, true);
    headline_.push_back(
        headline_.empty() ? words_.say(finding.first, test_, best, others)
                          : words_.say(finding.next, best, others));
  }

  /// That the best alternative differs significantly from none of these.
  std::string neither(const std::vector<Outcome>& alike) {
    const auto best = introduced(best_);
    Names titles;
    for (const auto& one : alike) titles.push_back(introduced(one.condition));
    const bool isOfSeveral =
        std::ranges::all_of(alike, [](const auto& one) { return one.testedCohorts > 1; });
    const auto others = listed(titles, words_);
    const auto inAny = isOfSeveral ? " " + words_("in any cohort") : std::string();
    return headline_.empty() ? words_.say(kAlike.first, test_, best, others, inAny)
                             : words_.say(kAlike.next, best, others, inAny);
  }

  /// Whether the tests within people find the differences that the pooled test found, too.
  std::string withinPeople(const std::vector<Outcome>& outcomes) {
    std::vector<Outcome> found;
    Names none;
    Names untested;
    for (const auto& one : outcomes) {
      const auto& title = section_.conditionTitle(one.condition);
      if (one.testedWithin == 0) {
        untested.push_back(title);
      } else if (one.significantWithin == 0) {
        none.push_back(title);
      } else {
        found.push_back(one);
      }
    }
    const auto test = testInWords(protocols::TestType::PairedT, words_);
    if (found.empty() && untested.empty()) {
      return words_.say(
          "Compared within people ({}, exploratory), no difference from it is significant.", test);
    }
    Names clauses;
    const auto holds = words_.say("holds for {}", where(found, &Outcome::significantWithin, false));
    const auto fails = words_.say("does not hold for {}", listed(none, words_));
    const auto unknown = words_.say("cannot be tested for {}", listed(untested, words_));
    if (!found.empty()) clauses.push_back(holds);
    if (!none.empty()) clauses.push_back(fails);
    if (!untested.empty()) clauses.push_back(unknown);
    return words_.say(
        "Compared within people ({}, exploratory), this {}.", test, base::joined(clauses, ", "));
  }

  /// The title of a condition, with the name of its force model where it is first named.
  std::string introduced(const std::string& condition) {
    const bool isNew = introduced_.insert(condition).second;
    return isNew ? section_.introducedTitle(condition) : section_.conditionTitle(condition);
  }

  Outcome outcomeOf(const FamilyResult& family, const std::string& other) {
    Outcome outcome{.condition = other};
    for (const auto& part : family.cohorts) {
      for (const auto& row : declaredIn(family, part)) {
        if (other == best_ || !row.has(best_) || !row.has(other) || !row.isDefined()) continue;
        const double sign = row.group1 == best_ ? 1.0 : -1.0;
        const double difference = sign * *row.difference->estimate.value;
        const bool isSignificant = row.test->isSignificant.value_or(false);
        const bool agrees = agreesWithin(row, sign * difference);
        outcome.mostPeople = std::max(outcome.mostPeople, row.people);
        ++outcome.testedCohorts;
        if (isNegligible(family, row)) ++outcome.negligible;
        outcome.points.push_back(difference);
        if (isSignificant)
          ++(difference > 0.0 ? outcome.significantlyHigher : outcome.significantlyLower);
        if (row.withinPeople->p) ++outcome.testedWithin;
        if (agrees && isSignificant) ++outcome.significantWithin;
      }
    }
    return outcome;
  }

  const ReportSection& section_;
  const words::Words& words_;
  std::string best_;  ///< condition
  std::string test_;  ///< the declared test, in words
  std::set<std::string> introduced_;
  Names headline_;  ///< what was found
  Names more_;      ///< where, how much, and what was not tested
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

Answer conclusionOf(const ReportSection& section) {
  return VerdictWriter(section).all();
}

std::string verdictOf(const ReportSection& section) {
  const auto verdict = conclusionOf(section);
  return verdict.finding + (verdict.more.empty() ? "" : " ") + verdict.more;
}

}  // namespace study::report
