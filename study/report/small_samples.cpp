#include "study/report/small_samples.h"

#include <algorithm>
#include <set>

#include "analysis/numerics/determined_unknowns.h"
#include "analysis/registry/registry.h"

namespace study::report {
namespace {

constexpr std::uint64_t kFewestVotes = 2;  // one vote is as likely for any alternative

base::Message reasonOf(const analysis::StatisticalTest& test) {
  return base::messageOf<kSmallSampleMessages>("fewer_people", test.fewestPeople);
}

bool isLeftOut(const base::Message& reason) {
  return reason.key() == kSmallSampleMessages.front().key;
}

/// Removes the result of a test of @p people that needs more.
void leaveOut(analysis::TestRow& row, std::size_t people) {
  const auto& test = analysis::statisticalTest(row.id);
  if (people >= test.fewestPeople || (!row.p && !row.effect.value)) return;
  analysis::TestRow kept;
  kept.id = row.id;
  kept.group1 = row.group1;
  kept.group2 = row.group2;
  kept.n1 = row.n1;
  kept.n2 = row.n2;
  kept.isInFamily = row.isInFamily;
  kept.reason = reasonOf(test);
  row = kept;
}

template <typename Reliability>
void leaveOut(Reliability& reliability, std::string_view id) {
  const auto& test = analysis::statisticalTest(id);
  if (reliability.respondents >= test.fewestPeople || !reliability.value) return;
  Reliability kept;
  kept.respondents = reliability.respondents;
  kept.items = reliability.items;
  kept.reason = reasonOf(test);
  reliability = kept;
}

using ItemIds = std::set<std::string>;

/// Of how many items the answers of one person follow from the means of @p sets of items.
std::size_t itemsGivenAwayBy(const std::vector<ItemIds>& sets) {
  ItemIds items;
  for (const auto& set : sets) items.insert(set.begin(), set.end());
  std::vector<std::vector<double>> sums;
  for (const auto& set : sets) {
    auto& sum = sums.emplace_back();
    for (const auto& item : items) sum.push_back(set.contains(item) ? 1.0 : 0.0);
  }
  return analysis::determinedUnknowns(sums);
}

/// Removes what shows an answer of the only participant of a cohort to a single item.
void leaveOutItemsOfOnePerson(
    InstrumentSummary& summary,
    const questionnaires::Instrument& instrument,
    const std::vector<FamilyResult>& families) {
  std::vector<ItemIds> shown;  // with their means: what families compare, then scores
  for (const auto& family : families) {
    if (family.family.instrument != instrument.id) continue;
    auto& ids = shown.emplace_back();
    for (const auto& item : protocols::comparedItems(family.family, instrument.items)) {
      ids.insert(item.id);
    }
  }
  std::set<std::string_view> hidden;
  for (const auto& score : instrument.scores) {
    const auto before = itemsGivenAwayBy(shown);
    shown.emplace_back(score.items.begin(), score.items.end());
    if (itemsGivenAwayBy(shown) == before) continue;
    shown.pop_back();
    hidden.insert(score.id);
  }
  std::erase_if(summary.scores, [&](const auto& score) {
    return score.values.size() == 1 && hidden.contains(score.score);
  });
  std::erase_if(
      summary.acceptable, [](const auto& acceptable) { return acceptable.item.answered == 1; });
}

std::size_t peopleIn(const analysis::AnswerTable& table) {
  std::set<std::size_t> people;
  for (const auto& answer : table.answers) people.insert(answer.participant);
  return people.size();
}

}  // namespace

void leaveOutSmallSamples(
    Results& results, const std::vector<questionnaires::Instrument>& instruments) {
  for (auto& summary : results.instruments) {
    const auto found =
        std::ranges::find(instruments, summary.instrument, &questionnaires::Instrument::id);
    if (found != instruments.end()) leaveOutItemsOfOnePerson(summary, *found, results.families);
  }
  for (auto* votes : {&results.votes, &results.siteVotes}) {
    for (auto& vote : *votes) {
      if (vote.votes.total() < kFewestVotes) vote.test = {};
    }
  }
  for (auto& family : results.families) {
    for (auto& part : family.cohorts) {
      const auto people = peopleIn(part.table);
      for (auto& pair : part.within.rows) {
        for (auto& row : pair.tests) leaveOut(row, people);
      }
      for (auto& row : part.within.overall) leaveOut(row, people);
      for (auto& method : part.checks.methods) {
        leaveOut(method.alpha, "cronbach_alpha");
        leaveOut(method.omega, "omega_total");
      }
    }
    for (auto& between : family.between) {
      for (auto& row : between.tests) {
        if (row.n1 && row.n2) leaveOut(row, std::min(*row.n1, *row.n2));
      }
    }
  }
}

std::string leftOutInWords(const FamilyResult& family, const words::Words& words) {
  std::set<std::string_view> ids;
  const auto noteIfLeftOut = [&](std::string_view id, const base::Message& reason) {
    if (isLeftOut(reason)) ids.insert(id);
  };
  for (const auto& part : family.cohorts) {
    for (const auto& pair : part.within.rows) {
      for (const auto& row : pair.tests) noteIfLeftOut(row.id, row.reason);
    }
    for (const auto& row : part.within.overall) noteIfLeftOut(row.id, row.reason);
    for (const auto& method : part.checks.methods) {
      noteIfLeftOut("cronbach_alpha", method.alpha.reason);
      noteIfLeftOut("omega_total", method.omega.reason);
    }
  }
  for (const auto& between : family.between) {
    for (const auto& row : between.tests) noteIfLeftOut(row.id, row.reason);
  }
  std::string list;
  std::size_t fewest = 0;
  for (const auto& test : analysis::statisticalTests()) {
    if (!ids.contains(test.id)) continue;
    list += (list.empty() ? "" : "; ") + words(test.title);
    fewest = std::max(fewest, test.fewestPeople);
  }
  const auto sentence = words.say(
      "Left out where a cohort is too small: {} (each needs at least {} participants).",
      list,
      fewest);
  return list.empty() ? list : sentence;
}

}  // namespace study::report
