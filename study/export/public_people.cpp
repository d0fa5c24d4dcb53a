#include "study/export/public_people.h"

#include <algorithm>
#include <set>
#include <utility>

#include "study/export/condition_codes.h"
#include "study/storage/answer_repository.h"

namespace study {
namespace {

std::string asWritten(const questionnaires::Response& response) {
  const auto stored = storage::stored(response);
  if (stored.point) return std::to_string(*stored.point);
  return stored.number ? exactDecimal(*stored.number) : stored.text.value_or("");
}

}  // namespace

std::vector<BackgroundQuestion> backgroundQuestionsOf(const protocols::LoadedProtocol& loaded) {
  std::vector<BackgroundQuestion> questions;
  for (const auto& phase : loaded.protocol.phases) {
    const auto* instrument = loaded.instrument(phase.instrument);
    if (phase.type != protocols::PhaseType::Form || instrument == nullptr) continue;
    for (const auto& item : instrument->items) {
      if (item.isIdentifying || !isQuasiIdentifier(item)) continue;
      questions.push_back(
          {phase.id, &item, GeneralisationHierarchy(item, loaded.protocol.languages.front())});
    }
  }
  return questions;
}

std::string BackgroundQuestion::column() const {
  std::string name = phase + "_" + item->id;
  for (char& c : name) {
    if (c == '-' || c == '.' || c == ' ') c = '_';
  }
  return name;
}

PublicPeople::PublicPeople(Study& study, RunMode mode)
    : study_(study), mode_(mode), questions_(backgroundQuestionsOf(study.protocol())) {
  const storage::Records records(study.database());
  std::set<std::string> seen;
  for (auto& session : records.sessions()) {
    const bool isTheirs = session.isCompleted() && session.runMode == mode;
    if (!isTheirs || !seen.insert(session.participant).second) continue;
    people_.emplace(session.id, sessions_.size());
    sessions_.push_back(std::move(session));
  }
  const auto isCounted = [&](const storage::StepRecord& step) {
    return step.isFinished() && people_.count(step.visit.session) == 1;
  };
  for (auto& answer : records.answers()) {
    if (isCounted(answer.step)) answers_.push_back(std::move(answer));
  }
  for (auto& trial : records.trials()) {
    if (isCounted(trial.step)) trials_.push_back(std::move(trial));
  }
}

std::optional<std::size_t> PublicPeople::personOf(SessionId session) const {
  const auto found = people_.find(session);
  return found == people_.end() ? std::nullopt : std::optional(found->second);
}

std::vector<QuasiIdentifier> PublicPeople::identifiers() const {
  std::vector<QuasiIdentifier> identifiers{
      identifierFrom(kCohortColumn, &storage::SessionRecord::cohort)};
  auto sites = identifierFrom(kSiteColumn, &storage::SessionRecord::site);
  const bool areSeveral = std::ranges::any_of(
      sites.exact, [&](const auto& site) { return site != sites.exact.front(); });
  if (areSeveral) identifiers.push_back(std::move(sites));
  for (const auto& question : questions_) identifiers.push_back(backgroundIdentifier(question));
  identifiers.push_back(orderIdentifier());
  return identifiers;
}

QuasiIdentifier PublicPeople::identifierFrom(
    const char* name, std::string storage::SessionRecord::*member) const {
  QuasiIdentifier identifier{.name = name, .exact = {}, .levels = {}};
  for (const auto& session : sessions_) identifier.exact.push_back(session.*member);
  identifier.levels = {identifier.exact};
  return identifier;
}

QuasiIdentifier PublicPeople::backgroundIdentifier(const BackgroundQuestion& question) const {
  const std::size_t levelCount = question.hierarchy.levelCount();
  QuasiIdentifier identifier{
      .name = question.column(),
      .exact = Values(count()),
      .levels = std::vector<Values>(levelCount, Values(count()))};
  for (const auto& answer : answers_) {
    const bool isIt = answer.step.kind == StepKind::Form && answer.step.phase == question.phase &&
                      answer.answer.item == question.item->id;
    if (!isIt) continue;
    const std::size_t person = people_.at(answer.step.visit.session);
    identifier.exact[person] = asWritten(answer.answer.response);
    for (std::size_t level = 0; level < levelCount; ++level) {
      identifier.levels[level][person] =
          question.hierarchy.releasedValue(level, answer.answer.response);
    }
  }
  return identifier;
}

QuasiIdentifier PublicPeople::orderIdentifier() const {
  const auto codes = conditionCodes(study_, mode_);
  std::vector<std::map<std::pair<int, std::string>, std::map<int, std::string>>> codesByPerson(
      count());
  for (const auto& trial : trials_) {
    if (trial.step.isOptionalRepetition())
      continue;  // an optional trial has no position in the order
    auto& blocks = codesByPerson[people_.at(trial.step.visit.session)];
    const auto code = codes.find(trial.step.condition);
    const auto& phases = study_.protocol().protocol.phases;
    const auto phase = std::ranges::find_if(
        phases, [&](const auto& known) { return known.id == trial.step.phase; });
    const int place = static_cast<int>(phase - phases.begin());
    blocks[{place, trial.step.phase}][trial.step.position] =
        code == codes.end() ? "" : code->second;
  }
  QuasiIdentifier orderIdentifier{.name = kOrderColumn, .exact = Values(count()), .levels = {}};
  for (std::size_t person = 0; person < count(); ++person) {
    auto& text = orderIdentifier.exact[person];
    for (const auto& [block, positions] : codesByPerson[person]) {
      text += (text.empty() ? "" : "; ") + block.second + ":";
      for (const auto& [position, code] : positions) text += " " + code;
    }
  }
  orderIdentifier.levels = {orderIdentifier.exact};
  return orderIdentifier;
}

}  // namespace study
