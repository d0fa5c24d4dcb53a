#include <algorithm>
#include <map>
#include <set>

#include "study/report/study_parts.h"
#include "study/results/vote_tables.h"

namespace study::report {
namespace {

using Names = std::vector<std::string>;

std::string joined(const Names& names) {
  std::string list;
  for (const auto& name : names) list += (list.empty() ? "" : ", ") + name;
  return list;
}

/// Says what was found without statistics.
class VerdictWriter {
 public:
  explicit VerdictWriter(const ReportSection& section) : section_(section), words_(section.words) {}

  std::string all() {
    std::string text = votes();
    const auto* family = mainFamily(section_);
    if (family == nullptr) return text;
    if (best_.empty()) text += (text.empty() ? "" : " ") + ratings(*family);
    return text + comparisons(*family);
  }

 private:
  /// Which alternative was named most often; empty if several were.
  std::string votes() {
    for (const auto& table : voteTables(section_.results)) {
      const auto total = table.total.total();
      if (total == 0) continue;
      std::uint64_t most = 0;
      for (const auto& share : table.total.shares()) most = std::max(most, share.votes);
      Names named;
      for (const auto& share : table.total.shares()) {
        if (share.votes == most) named.push_back(share.option);
      }
      std::set<std::string> rounds;
      for (const auto& cohort : table.cohorts) {
        for (const auto* vote : cohort.rounds) rounds.insert(vote->phase);
      }
      if (named.size() > 1) continue;
      best_ = named.front();
      return said(*rounds.begin(), most, total, rounds.size());
    }
    return {};
  }

  /// @param phase  one that asked
  std::string said(
      const std::string& phase, std::uint64_t most, std::uint64_t total, std::size_t rounds) const {
    const auto people = section_.results.completed();
    const auto origin =
        total != static_cast<std::uint64_t>(people) * rounds ? words_.say("in {} rounds", rounds)
        : rounds == 1
            ? words_("one vote each")
            : words_.count(people, "{} person × {} rounds", "{} people × {} rounds", rounds);
    const auto asked = questionIn(phase);
    const auto resembled = words_.count(
        people,
        "To {} participant, {} resembled the real tool most: {} of {} votes ({}).",
        "To {} participants, {} resembled the real tool most: {} of {} votes ({}).",
        section_.introducedTitle(best_),
        most,
        total,
        origin);
    const auto answered = words_.count(
        people,
        "Asked “{1}”, {0} participant named {2}: {3} of {4} votes ({5}).",
        "Asked “{1}”, {0} participants named {2} most often: {3} of {4} votes ({5}).",
        asked == nullptr ? std::string() : questionOf(*asked, words_.language()),
        section_.introducedTitle(best_),
        most,
        total,
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

  /// Which alternative was rated highest, if no vote says which one was best.
  std::string ratings(const FamilyResult& family) {
    std::map<std::string, std::pair<double, double>> sums;  // answers, points
    for (const auto& part : family.cohorts) {
      for (const auto& one : part.conditions) {
        if (one.answers.total() == 0) continue;
        auto& [answers, points] = sums[one.name];
        answers += static_cast<double>(one.answers.total());
        points += static_cast<double>(one.answers.total()) * *one.answers.mean();
      }
    }
    const auto mean = [](const auto& sum) { return sum.second.second / sum.second.first; };
    best_ = std::ranges::max_element(sums, {}, mean)->first;
    const auto people = section_.results.completed();
    return words_.count(
        people,
        "{} participant rated {} highest.",
        "{} participants rated {} highest.",
        section_.introducedTitle(best_));
  }

  /// Whether the ratings of the best alternative differ from those of the others.
  std::string comparisons(const FamilyResult& family) const {
    if (!family.isDeclared) return " " + words_("All comparisons are exploratory.");
    Names higher;
    Names alike;
    std::string others;
    for (const auto& condition : section_.protocol.conditions) {
      Names above;
      Names below;
      std::size_t tested = 0;
      for (const auto& part : family.cohorts) {
        for (const auto& row : declaredIn(family, part)) {
          const bool isFirst = row.group1 == best_ && row.group2 == condition.id;
          const bool isSecond = row.group2 == best_ && row.group1 == condition.id;
          if ((!isFirst && !isSecond) || !row.isDefined()) continue;
          ++tested;
          if (!row.test->isSignificant.value_or(false)) continue;
          const bool isAbove = (*row.difference->estimate.value > 0.0) == isFirst;
          (isAbove ? above : below).push_back(section_.cohortTitle(part.cohort));
        }
      }
      if (tested == 0) continue;
      const auto title = section_.introducedTitle(condition.id);
      if (above.size() == tested) higher.push_back(title);
      if (above.empty() && below.empty()) alike.push_back(title);
      if (!above.empty() && above.size() < tested) {
        others +=
            " " +
            words_.say(
                "It was rated significantly higher than {} only by: {}.", title, joined(above));
      }
      if (!below.empty()) {
        others +=
            " " +
            words_.say("It was rated significantly lower than {} by: {}.", title, joined(below));
      }
    }
    std::string text;
    if (!higher.empty()) {
      text += " " + words_.say("It was rated significantly higher than {}.", joined(higher));
    }
    text += others;
    if (!alike.empty()) {
      text += " " + words_.say("Its rating does not differ significantly from {}.", joined(alike));
    }
    return text;
  }

  const ReportSection& section_;
  const words::Words& words_;
  std::string best_;  ///< condition; empty: not known
};

}  // namespace

std::string verdictOf(const ReportSection& section) {
  return VerdictWriter(section).all();
}

}  // namespace study::report
