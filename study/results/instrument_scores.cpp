#include "study/results/instrument_scores.h"

#include <algorithm>
#include <cmath>

#include "analysis/data/vote_shares.h"
#include "analysis/hypothesis_tests/t_tests.h"
#include "questionnaires/model/answer.h"
#include "questionnaires/scoring/scoring.h"

namespace study {
namespace {

using questionnaires::Answer;
using questionnaires::Instrument;

/// The answers of one participant in one visit of a step.
struct Form {
  std::string participant;
  std::string cohort;
  std::string condition;
  const Instrument* asked = nullptr;  ///< in the version of the session
  std::vector<Answer> answers;
};

/// @p answers with those reversed whose key was another, so that @p now keys them as @p asked did.
std::vector<Answer> keyedAs(
    const Instrument& now, const Instrument& asked, std::vector<Answer> answers) {
  for (auto& answer : answers) {
    const auto* item = asked.item(answer.itemId);
    const auto* nowItem = now.item(answer.itemId);
    if (item == nullptr || nowItem == nullptr || item->key == nowItem->key) continue;
    const auto& reversed = item->key == -1 ? *item : *nowItem;
    if (auto* point = std::get_if<std::int64_t>(&*answer.response)) {
      *point = questionnaires::keyedPoint(reversed, *point);
    } else if (auto* number = std::get_if<double>(&*answer.response)) {
      *number = questionnaires::keyedNumber(reversed, *number);
    }
  }
  return answers;
}

/// Collects the summary of one instrument.
class InstrumentSummariser {
 public:
  InstrumentSummariser(
      const protocols::Protocol& protocol, const Instrument& instrument, std::vector<Form> forms)
      : protocol_(protocol), instrument_(instrument), forms_(std::move(forms)) {}

  InstrumentSummary all() {
    result_.instrument = instrument_.id;
    result_.forms = forms_.size();
    for (const auto& form : forms_) {
      const auto consistency = consistencyOf(*form.asked, form.answers);
      if (consistency && consistency->isSuspicious) ++result_.contradictory;
    }
    for (const auto& cohort : protocol_.cohorts) {
      for (const auto& score : instrument_.scores) addScores(score, cohort.id);
      addAcceptability(cohort.id);
    }
    return std::move(result_);
  }

 private:
  void addScores(const questionnaires::Score& score, const std::string& cohort) {
    if (instrument_.occasions == questionnaires::Occasions::BeforeAndAfter) {
      addChanges(score, cohort);
      return;
    }
    for (const auto& condition : conditionsIn(cohort)) {
      ScoreSummary summary{.score = score.id, .cohort = cohort, .condition = condition};
      std::map<std::string, std::vector<double>> byParticipant;
      for (const auto& form : forms_) {
        if (form.cohort != cohort || form.condition != condition) continue;
        const auto* own = protocols::comparableScore(*form.asked, instrument_, score);
        if (own == nullptr) continue;
        const auto found = computeScore(*form.asked, *own, form.answers);
        if (found.answered == 0) continue;  // the item set of this visit has no item of the score
        if (found.value) byParticipant[form.participant].push_back(*found.value);
        if (!found.value) ++summary.missing;
      }
      for (const auto& [participant, values] : byParticipant) {
        double sum = 0.0;
        for (const double value : values) sum += value;
        summary.values.push_back(sum / static_cast<double>(values.size()));
      }
      add(std::move(summary));
    }
  }

  /// The conditions that the forms are about, in the protocol's order, after "" for forms that are
  /// about none.
  std::vector<std::string> conditionsIn(const std::string& cohort) const {
    std::vector<std::string> all{""};
    for (const auto& condition : protocol_.conditions) all.push_back(condition.id);
    std::erase_if(all, [&](const auto& condition) {
      return std::ranges::none_of(forms_, [&](const auto& form) {
        return form.cohort == cohort && form.condition == condition;
      });
    });
    return all;
  }

  /// For participants with at least two forms: summaries of the score of the first form, of the
  /// last form, and of last − first.
  void addChanges(const questionnaires::Score& score, const std::string& cohort) {
    std::map<std::string, std::vector<const Form*>> byParticipant;
    for (const auto& form : forms_) {
      const bool isMeant = form.cohort == cohort &&
                           protocols::comparableScore(*form.asked, instrument_, score) != nullptr;
      if (isMeant) byParticipant[form.participant].push_back(&form);
    }
    if (byParticipant.empty()) return;
    ScoreSummary before{.score = score.id, .cohort = cohort, .occasion = "before"};
    ScoreSummary after{.score = score.id, .cohort = cohort, .occasion = "after"};
    ScoreSummary change{.score = score.id, .cohort = cohort, .occasion = "change"};
    for (const auto& [participant, forms] : byParticipant) {
      if (forms.size() < 2) {
        ++change.missing;
        continue;
      }
      const auto& asked = *forms.back()->asked;
      const auto first = keyedAs(asked, *forms.front()->asked, forms.front()->answers);
      const auto found = scoreChange(asked, *asked.score(score.id), first, forms.back()->answers);
      if (found.before) before.values.push_back(*found.before);
      if (found.after) after.values.push_back(*found.after);
      if (found.change) change.values.push_back(*found.change);
      if (!found.change) ++change.missing;
    }
    for (auto* summary : {&before, &after, &change}) add(std::move(*summary));
  }

  void add(ScoreSummary summary) {
    const std::vector<double> zeros(summary.values.size(), 0.0);
    const auto test = analysis::pairedTTest(summary.values, zeros);
    summary.mean = test.meanDifference;
    if (!summary.mean && summary.values.size() == 1) summary.mean = summary.values.front();
    if (test.variance) summary.standardDeviation = std::sqrt(*test.variance);
    summary.interval = confidenceInterval(test, 0.95);
    result_.scores.push_back(std::move(summary));
  }

  /// The last answer of each participant about each condition.
  void addAcceptability(const std::string& cohort) {
    for (const auto& condition : conditionsIn(cohort)) {
      std::map<std::string, const Form*> last;
      for (const auto& form : forms_) {
        if (form.cohort == cohort && form.condition == condition) last[form.participant] = &form;
      }
      std::vector<std::vector<Answer>> participants;
      for (const auto& [participant, form] : last) {
        participants.push_back(keyedAs(instrument_, *form->asked, form->answers));
      }
      for (auto& item : acceptabilityOf(instrument_, participants)) {
        AcceptabilitySummary summary{
            .cohort = cohort, .condition = condition, .item = std::move(item), .interval = {}};
        summary.interval = analysis::wilsonInterval(summary.item.acceptable, summary.item.answered);
        result_.acceptable.push_back(std::move(summary));
      }
    }
  }

  const protocols::Protocol& protocol_;
  const Instrument& instrument_;
  std::vector<Form> forms_;
  InstrumentSummary result_;
};

bool isSummarised(const Instrument& instrument) {
  const bool hasThreshold = std::ranges::any_of(
      instrument.items, [](const auto& item) { return item.acceptableFrom.has_value(); });
  return hasThreshold || !instrument.scores.empty() || instrument.consistency;
}

}  // namespace

std::vector<InstrumentSummary> summariseInstruments(
    const ProtocolVersions& versions,
    const std::map<SessionId, storage::SessionRecord>& sessions,
    const std::vector<storage::AnswerRecord>& answers) {
  std::vector<InstrumentSummary> summaries;
  const auto& loaded = versions.newest();
  for (const auto& instrument : loaded.instruments) {
    if (!isSummarised(instrument)) continue;
    std::map<VisitKey, Form> forms;
    for (const auto& answer : answers) {
      if (answer.step.instrument != instrument.id) continue;
      const auto& session = sessions.at(answer.step.visit.session);
      auto& form = forms[answer.step.visit];
      form.participant = session.participant;
      form.cohort = session.cohort;
      form.condition = answer.step.condition;
      form.asked = versions.of(session.protocol).instrument(instrument.id);
      form.answers.push_back({answer.answer.item, answer.answer.response});
    }
    std::vector<Form> list;
    for (auto& [visit, form] : forms) list.push_back(std::move(form));
    if (list.empty()) continue;
    summaries.push_back(InstrumentSummariser(loaded.protocol, instrument, std::move(list)).all());
  }
  return summaries;
}

}  // namespace study
