#include "study/results/answer_tables.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <set>
#include <variant>

#include "protocols/changed_meaning.h"
#include "questionnaires/model/answer.h"
#include "questionnaires/scoring/scoring.h"

namespace study {
namespace {

std::optional<std::size_t> placeOf(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::ranges::find(names, name);
  if (found == names.end()) return std::nullopt;
  return static_cast<std::size_t>(found - names.begin());
}

const protocols::ConditionQuestionnaire* questionnaireIn(
    const protocols::Phase& phase, const protocols::Family& family) {
  const bool isMeant = family.blocks.empty() || placeOf(family.blocks, phase.id).has_value();
  if (phase.type != protocols::PhaseType::Block || !isMeant) return nullptr;
  for (const auto& questionnaire : phase.trials.questionnaires) {
    if (questionnaire.instrument == family.instrument) return &questionnaire;
  }
  return nullptr;
}

/// The answers of one participant in one visit of a step.
struct AnsweredForm {
  ParticipantAnswer first;
  std::vector<questionnaires::Answer> answers;
};

std::vector<AnsweredForm> formsOf(const std::vector<ParticipantAnswer>& answers) {
  std::map<VisitKey, AnsweredForm> forms;
  for (const auto& answer : answers) {
    auto& form =
        forms.try_emplace(answer.record->step.visit, AnsweredForm{answer, {}}).first->second;
    form.answers.push_back({answer.record->answer.item, answer.record->answer.response});
  }
  std::vector<AnsweredForm> all;
  for (auto& [visit, form] : forms) all.push_back(std::move(form));
  return all;
}

}  // namespace

std::optional<double> numberOf(const questionnaires::Response& response) {
  if (const auto* point = std::get_if<std::int64_t>(&response)) return static_cast<double>(*point);
  if (const auto* number = std::get_if<double>(&response)) return *number;
  return std::nullopt;
}

std::vector<std::string> conditionsOf(
    const protocols::Protocol& protocol, const protocols::Family& family) {
  std::set<std::string> named;
  for (const auto& pair : family.comparisons) named.insert({pair.first, pair.second});
  std::vector<std::string> conditions;
  for (const auto& condition : protocol.conditions) {
    if (named.count(condition.id) > 0) conditions.push_back(condition.id);
  }
  return conditions;
}

FamilyLayout::FamilyLayout(const protocols::LoadedProtocol& loaded, const protocols::Family& family)
    : instrument_(*loaded.instrument(family.instrument)),
      score_(family.score.empty() ? nullptr : instrument_.score(family.score)) {
  table_.methods = conditionsOf(loaded.protocol, family);
  for (const auto& phase : loaded.protocol.phases) {
    if (questionnaireIn(phase, family) != nullptr) table_.rounds.push_back(phase.id);
  }
  if (const auto scale = protocols::scaleOf(family, instrument_)) {
    table_.lowest = scale->lowest;
    table_.highest = scale->highest;
    table_.isPointScale = scale->isPointScale;
  }
  for (const auto& item : protocols::comparedItems(family, instrument_.items)) {
    if (protocols::scaleOf(item)) table_.statements.push_back(item.id);
  }
  if (score_ != nullptr) table_.statements.push_back(score_->id);
}

std::optional<FamilyLayout::Cell> FamilyLayout::cellOf(const Origin& origin, double answer) const {
  if (origin.instrument != instrument_.id) return std::nullopt;
  const auto method = placeOf(table_.methods, origin.condition);
  const auto round = placeOf(table_.rounds, origin.phase);
  const auto statement = placeOf(table_.statements, origin.item);
  if (!method || !round || !statement) return std::nullopt;
  if (score_ != nullptr) return Cell{*method, *round, *statement, answer};
  const auto& now = *instrument_.item(origin.item);
  const auto* asked = origin.asked == nullptr ? &now : origin.asked->item(origin.item);
  if (asked == nullptr || !protocols::haveSameScale(*asked, now)) return std::nullopt;
  const double score = questionnaires::keyedNumber(*asked, answer);
  const bool isOnScale = (!table_.isPointScale || score == std::round(score)) &&
                         score >= table_.lowest && score <= table_.highest;
  if (!isOnScale) return std::nullopt;
  return Cell{*method, *round, *statement, score};
}

analysis::AnswerTable answerTable(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const std::vector<std::string>& people,
    const std::vector<ParticipantAnswer>& answers) {
  const FamilyLayout layout(loaded, family);
  auto table = layout.table();
  table.participants = people;
  const auto add = [&](const ParticipantAnswer& answer, const std::string& what, double value) {
    const auto& step = answer.record->step;
    const auto person = placeOf(table.participants, *answer.participant);
    const auto cell =
        layout.cellOf({step.instrument, step.phase, step.condition, what, answer.asked}, value);
    if (step.kind != StepKind::Questionnaire || !person || !cell) return;
    table.answers.push_back(
        {.participant = *person,
         .method = cell->method,
         .round = cell->round,
         .statement = cell->statement,
         .position = step.position,
         .score = cell->score});
  };
  if (const auto* score = layout.score()) {
    const auto& now = *loaded.instrument(family.instrument);
    for (const auto& form : formsOf(answers)) {
      const auto& asked = form.first.asked == nullptr ? now : *form.first.asked;
      const auto* own = protocols::comparableScore(asked, now, *score);
      if (own == nullptr) continue;
      const auto value = questionnaires::scoreValue(asked, *own, form.answers);
      if (value) add(form.first, score->id, *value);
    }
    return table;
  }
  for (const auto& answer : answers) {
    if (const auto given = numberOf(answer.record->answer.response)) {
      add(answer, answer.record->answer.item, *given);
    }
  }
  return table;
}

std::vector<std::size_t> completeAnswerCounts(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const analysis::AnswerTable& table) {
  std::vector<std::size_t> expected(table.methods.size());
  const auto& instrument = *loaded.instrument(family.instrument);
  for (const auto& phase : loaded.protocol.phases) {
    const auto* questionnaire = questionnaireIn(phase, family);
    if (questionnaire == nullptr) continue;
    for (std::size_t i = 0; i < expected.size(); ++i) {
      if (!placeOf(phase.trials.conditions, table.methods[i])) continue;
      const auto items = instrument.itemsOf(questionnaire->itemSetFor(table.methods[i]));
      expected[i] +=
          family.score.empty() ? protocols::comparedItems(family, items).size() : std::size_t{1};
    }
  }
  return expected;
}

bool asksSameStatements(const protocols::LoadedProtocol& loaded, const protocols::Family& family) {
  if (!family.score.empty()) return true;
  const auto& instrument = *loaded.instrument(family.instrument);
  std::set<std::set<std::string>> asked;
  for (const auto& condition : conditionsOf(loaded.protocol, family)) {
    std::set<std::string> ids;
    for (const auto& phase : loaded.protocol.phases) {
      const auto* questionnaire = questionnaireIn(phase, family);
      if (questionnaire == nullptr || !placeOf(phase.trials.conditions, condition)) continue;
      const auto items = instrument.itemsOf(questionnaire->itemSetFor(condition));
      for (const auto& item : protocols::comparedItems(family, items)) ids.insert(item.id);
    }
    asked.insert(std::move(ids));
  }
  return asked.size() < 2;
}

std::vector<std::size_t> comparativeStatements(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const analysis::AnswerTable& table) {
  const auto& instrument = *loaded.instrument(family.instrument);
  std::set<std::size_t> answered;
  for (const auto& answer : table.answers) answered.insert(answer.statement);
  std::vector<std::size_t> places;
  for (const std::size_t place : answered) {
    const auto* item = instrument.item(table.statements[place]);
    const bool isRelative =
        item != nullptr && item->comparedWith == questionnaires::Reference::Previous;
    if (isRelative && family.score.empty()) places.push_back(place);
  }
  return places;
}

}  // namespace study
