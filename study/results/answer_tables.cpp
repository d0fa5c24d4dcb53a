#include "study/results/answer_tables.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <set>
#include <variant>

#include "questionnaires/model/answer.h"

namespace study {
namespace {

std::optional<std::size_t> placeOf(const std::vector<std::string>& names, const std::string& name) {
  const auto found = std::find(names.begin(), names.end(), name);
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
    : instrument_(*loaded.instrument(family.instrument)) {
  table_.methods = conditionsOf(loaded.protocol, family);
  for (const auto& phase : loaded.protocol.phases) {
    if (questionnaireIn(phase, family) != nullptr) table_.rounds.push_back(phase.id);
  }
  for (const auto& item : protocols::comparedItems(family, instrument_.items)) {
    const auto scale = protocols::wholeScaleOf(item);
    if (!scale) continue;  // of an earlier version's protocol
    table_.lowest = scale->lowest;
    table_.highest = scale->highest;
    table_.statements.push_back(item.id);
  }
}

std::optional<FamilyLayout::Cell> FamilyLayout::cellOf(const Origin& origin, double answer) const {
  if (origin.instrument != instrument_.id) return std::nullopt;
  const auto method = placeOf(table_.methods, origin.condition);
  const auto round = placeOf(table_.rounds, origin.phase);
  const auto statement = placeOf(table_.statements, origin.item);
  if (!method || !round || !statement) return std::nullopt;
  const double score = questionnaires::keyedNumber(*instrument_.item(origin.item), answer);
  const bool isOnScale =
      score == std::round(score) && score >= table_.lowest && score <= table_.highest;
  if (!isOnScale) return std::nullopt;
  return Cell{*method, *round, *statement, static_cast<int>(score)};
}

analysis::AnswerTable answerTable(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const std::vector<std::string>& people,
    const std::vector<OwnedAnswer>& answers) {
  const FamilyLayout layout(loaded, family);
  auto table = layout.table();
  table.participants = people;
  for (const auto& [participant, record] : answers) {
    const auto& step = record->step;
    const auto person = placeOf(table.participants, *participant);
    const auto given = numberOf(record->answer.response);
    if (step.kind != StepKind::Questionnaire || !person || !given) continue;
    const auto cell =
        layout.cellOf({step.instrument, step.phase, step.condition, record->answer.item}, *given);
    if (!cell) continue;
    table.answers.push_back(
        {.participant = *person,
         .method = cell->method,
         .round = cell->round,
         .statement = cell->statement,
         .position = step.position,
         .score = cell->score});
  }
  return table;
}

std::vector<std::size_t> expectedAnswers(
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
      const auto items = instrument.itemsOf(questionnaire->setFor(table.methods[i]));
      expected[i] += protocols::comparedItems(family, items).size();
    }
  }
  return expected;
}

std::vector<std::size_t> relativeStatements(
    const protocols::LoadedProtocol& loaded,
    const protocols::Family& family,
    const analysis::AnswerTable& table) {
  const auto& instrument = *loaded.instrument(family.instrument);
  std::set<std::size_t> answered;
  for (const auto& answer : table.answers) answered.insert(answer.statement);
  std::vector<std::size_t> places;
  for (const std::size_t place : answered) {
    const auto* item = instrument.item(table.statements[place]);
    if (item->reference == questionnaires::Reference::Previous) places.push_back(place);
  }
  return places;
}

}  // namespace study
