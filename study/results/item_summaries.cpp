#include "study/results/item_summaries.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <set>
#include <tuple>
#include <variant>

#include "questionnaires/model/answer.h"
#include "study/results/answer_tables.h"

namespace study {
namespace {

using protocols::PhaseType;
using questionnaires::AnswerKind;
using questionnaires::Item;
using storage::AnswerRecord;
using storage::Records;

double meanOf(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
}

/// Fills in the numbers of @p summary from its values.
void describe(ItemSummary& summary) {
  auto sorted = summary.values;
  if (sorted.empty()) return;
  std::ranges::sort(sorted);
  summary.mean = meanOf(sorted);
  summary.least = sorted.front();
  summary.most = sorted.back();
  summary.median = std::midpoint(sorted[(sorted.size() - 1) / 2], sorted[sorted.size() / 2]);
  if (sorted.size() < 2) return;
  double squares = 0.0;
  for (const double value : sorted) squares += (value - *summary.mean) * (value - *summary.mean);
  summary.standardDeviation = std::sqrt(squares / static_cast<double>(sorted.size() - 1));
}

std::vector<std::string> chosenIn(const questionnaires::Response& response) {
  if (const auto* one = std::get_if<std::string>(&response)) return {*one};
  if (const auto* several = std::get_if<std::vector<std::string>>(&response)) return *several;
  return {};
}

/// Collects the answers to every item.
class ItemSummariser {
 public:
  ItemSummariser(
      const protocols::LoadedProtocol& loaded,
      const std::map<SessionId, storage::SessionRecord>& sessions,
      const std::vector<AnswerRecord>& answers,
      const Records::Allocation& allocation)
      : loaded_(loaded), sessions_(sessions), allocation_(allocation) {
    bool isBefore = true;
    for (const auto& phase : loaded.protocol.phases) {
      if (phase.type == PhaseType::Block) isBefore = false;
      if (isBefore) beforeBlocks_.insert(phase.id);
    }
    for (const auto& answer : answers) {
      const auto* phase = loaded.protocol.phase(answer.step.phase);
      if (phase == nullptr || phase->type == PhaseType::Consent) continue;
      // a later version of the protocol may lack the cohort or condition
      const auto& cohort = sessions.at(answer.step.visit.session).cohort;
      if (loaded.protocol.cohort(cohort) == nullptr || !isKnown(answer.step.condition)) continue;
      answers_[{answer.step.instrument, answer.answer.item}].push_back(&answer);
      noteChoice(answer, *phase);
    }
  }

  ItemResults all() {
    ItemResults results;
    for (const auto& instrument : loaded_.instruments) {
      for (const auto& item : instrument.items) {
        if (!isDescribed(item)) continue;
        if (answerKindOf(item.type) == AnswerKind::Text) {
          addQuotes(instrument.id, item, results.quotes);
        } else {
          addSummaries(instrument.id, item, results.items);
        }
      }
    }
    return results;
  }

 private:
  bool isKnown(const std::string& condition) const {
    return condition.empty() || loaded_.protocol.condition(condition) != nullptr;
  }

  static bool isDescribed(const Item& item) {
    return !item.isIdentifying && item.consentOption.empty() &&
           item.optionSource == questionnaires::OptionSource::Listed;
  }

  template <typename Do>
  void forEachAnswer(const std::string& instrument, const Item& item, Do&& visit) const {
    const auto found = answers_.find({instrument, item.id});
    if (found == answers_.end()) return;
    for (const auto* answer : found->second) {
      visit(*answer, sessions_.at(answer->step.visit.session));
    }
  }

  /// Sort key: the order of cohorts and conditions in the protocol; items without a condition come
  /// first.
  std::tuple<std::size_t, std::size_t> sortKeyOf(
      const std::string& cohort, const std::string& condition) const {
    const auto& protocol = loaded_.protocol;
    const auto cohorts = std::ranges::find(protocol.cohorts, cohort, &protocols::Cohort::id);
    const auto found = std::ranges::find(protocol.conditions, condition, &protocols::Condition::id);
    return {
        static_cast<std::size_t>(cohorts - protocol.cohorts.begin()),
        condition.empty() ? 0 : static_cast<std::size_t>(found - protocol.conditions.begin()) + 1};
  }

  void addSummaries(
      const std::string& instrument, const Item& item, std::vector<ItemSummary>& all) const {
    struct Collected {
      ItemSummary summary;
      std::map<std::string, std::vector<double>> byParticipant;
      std::map<std::string, std::uint64_t> chosen;
    };
    std::map<std::tuple<std::size_t, std::size_t>, Collected> cells;
    forEachAnswer(instrument, item, [&](const AnswerRecord& answer, const auto& session) {
      auto& cell = cells[sortKeyOf(session.cohort, answer.step.condition)];
      cell.summary.instrument = instrument;
      cell.summary.item = item.id;
      cell.summary.cohort = session.cohort;
      cell.summary.condition = answer.step.condition;
      ++cell.summary.answers;
      if (const auto number = numberOf(answer.answer.response)) {
        cell.byParticipant[session.participant].push_back(*number);
      }
      for (const auto& id : chosenIn(answer.answer.response)) ++cell.chosen[id];
    });
    for (auto& [place, cell] : cells) {
      for (const auto& [participant, values] : cell.byParticipant) {
        cell.summary.values.push_back(meanOf(values));
      }
      describe(cell.summary);
      for (const auto& option : item.options) {
        cell.summary.options.emplace_back(option.id, cell.chosen[option.id]);
      }
      all.push_back(std::move(cell.summary));
    }
  }

  void addQuotes(const std::string& instrument, const Item& item, std::vector<Quote>& all) const {
    std::vector<Quote> quotes;
    forEachAnswer(instrument, item, [&](const AnswerRecord& answer, const auto&) {
      const auto* text = std::get_if<std::string>(&answer.answer.response);
      const bool isTold =
          text != nullptr && !text->empty() && beforeBlocks_.count(answer.step.phase) == 0;
      if (isTold)
        quotes.push_back(
            {instrument,
             item.id,
             conditionAnswered(answer),
             *text,
             loaded_.protocol.phase(answer.step.phase)->type == PhaseType::Interview});
    });
    // Sorted by text, so that the order does not reveal which participant wrote a text.
    std::ranges::sort(quotes, {}, [&](const Quote& quote) {
      return std::tuple(sortKeyOf({}, quote.condition), quote.isNote, quote.text);
    });
    std::ranges::move(quotes, std::back_inserter(all));
  }

  /// The condition that an answer is about: in a preference step the chosen condition.
  const std::string& conditionAnswered(const AnswerRecord& answer) const {
    const auto chosen = chosen_.find(answer.step.visit);
    return chosen == chosen_.end() ? answer.step.condition : chosen->second;
  }

  /// Stores the chosen condition if @p answer is the answer of a preference.
  void noteChoice(const AnswerRecord& answer, const protocols::Phase& phase) {
    if (phase.type != PhaseType::Preference) return;
    const auto* item = loaded_.instrument(phase.instrument)->item(answer.answer.item);
    const auto* felt = chosenCondition(allocation_, answer, item, phase.block);
    if (felt != nullptr && isKnown(*felt)) chosen_[answer.step.visit] = *felt;
  }

  const protocols::LoadedProtocol& loaded_;
  const std::map<SessionId, storage::SessionRecord>& sessions_;
  const Records::Allocation& allocation_;
  std::set<std::string> beforeBlocks_;  ///< ids of phases before the first block
  /// The answers to each item, by instrument and item.
  std::map<std::pair<std::string, std::string>, std::vector<const AnswerRecord*>> answers_;
  std::map<VisitKey, std::string> chosen_;  ///< condition, by the visit of a preference
};

}  // namespace

ItemResults summariseItems(
    const protocols::LoadedProtocol& loaded,
    const std::map<SessionId, storage::SessionRecord>& sessions,
    const std::vector<AnswerRecord>& answers,
    const Records::Allocation& allocation) {
  return ItemSummariser(loaded, sessions, answers, allocation).all();
}

}  // namespace study
