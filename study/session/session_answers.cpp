// Questions and answers of a session.
#include <algorithm>
#include <utility>

#include "base/search.h"
#include "study/session/identity_evidence.h"
#include "study/session/session.h"
#include "study/storage/answer_repository.h"

namespace study {
namespace {

using storage::Actor;

constexpr const char* kBenchmarkItem = "physical-cuts";

/// The answer in its stored form: the answer to a numeric item is a number, also if it was entered
/// without a decimal point.
GivenAnswer inStoredForm(const questionnaires::Item& item, GivenAnswer answer) {
  using questionnaires::AnswerKind;
  const bool isNumber = questionnaires::answerKindOf(item.type) == AnswerKind::Number;
  const auto* whole = std::get_if<std::int64_t>(&answer.response);
  if (isNumber && whole != nullptr) answer.response = static_cast<double>(*whole);
  return answer;
}

std::vector<questionnaires::Answer> responses(const std::vector<GivenAnswer>& answers) {
  std::vector<questionnaires::Answer> responses;
  for (const auto& answer : answers) responses.push_back({answer.item, answer.response});
  return responses;
}

}  // namespace

const questionnaires::Instrument* Session::instrument() const {
  return step().hasItems() ? protocol_->instrument(step().instrument) : nullptr;
}

std::vector<questionnaires::Item> Session::items() const {
  const auto* asked = instrument();
  return asked == nullptr ? std::vector<questionnaires::Item>() : asked->itemsOf(step().itemSet);
}

std::vector<GivenAnswer> Session::answers() const {
  return storage::AnswerRepository(study_.database()).of(visit());
}

storage::IdentityStore::Place Session::place() const {
  return {row_.participant, row_.number, row_.step, row_.attempt};
}

bool Session::isAsked(const questionnaires::Item& item) const {
  return !item.showIf.isSet() || questionnaires::isAsked(item, items(), responses(answers()));
}

std::vector<std::string> Session::missing() const {
  const auto asked = items();
  auto missing = questionnaires::unansweredItems(asked, responses(answers()));
  std::erase_if(missing, [&](const std::string& id) {
    const auto* item = base::withId(asked, id);
    if (item == nullptr || !item->isIdentifying) return false;
    return heldNames_.contains(id) || study_.identities().has(place(), id);
  });
  return missing;
}

void Session::requireAnswerable() const {
  require(next(row_.state, SessionEvent::FinishedStep).has_value(), "Nothing can be answered now.");
}

questionnaires::Item Session::askedItem(const std::string& id) const {
  const auto asked = items();
  const auto* item = base::withId(asked, id);
  require(item != nullptr, "'" + id + "' is not asked in this step.");
  return *item;
}

std::vector<std::string> Session::alternatives() const {
  const auto* phase = protocol_->protocol.phase(step().phase);
  const auto sessions = study_.sessions();
  std::vector<std::string> felt = step().alternatives;
  for (int i = 0; i < row_.step && !felt.empty(); ++i) {
    const auto& trial = plan_[static_cast<std::size_t>(i)];
    const bool isOffered = trial.kind == StepKind::Trial && !trial.isOptionalTrial &&
                           phase != nullptr && trial.phase == phase->block;
    if (!isOffered) continue;
    const VisitKey last{row_.id, i, sessions.attempts(row_.id, i)};
    if (sessions.statusOf(last) != storage::VisitStatus::Finished) {
      std::erase(felt, std::to_string(trial.label));
    }
  }
  return felt.empty() ? step().alternatives : felt;
}

void Session::record(const GivenAnswer& answer) {
  requireAnswerable();
  const auto item = askedItem(answer.item);
  const auto error = questionnaires::validationError(item, answer.response, alternatives());
  require(!error, error.value_or(""));
  if (item.isIdentifying) {
    storeIdentifying(item, answer);
    return;
  }
  transact([&] {
    storage::AnswerRepository(study_.database()).put(visit(), inStoredForm(item, answer), utcNow());
    appendEvent(
        Actor::Participant, EventKind::Answered, storage::valuesOf(inStoredForm(item, answer)));
  });
  storeHeldNames();
}

void Session::storeIdentifying(const questionnaires::Item& item, const GivenAnswer& answer) {
  const auto* text = std::get_if<std::string>(&answer.response);
  require(text != nullptr, "'" + item.id + "' names a person and can only be a text.");
  if (step().kind == StepKind::Consent && !gaveConsent()) {
    heldNames_[item.id] = *text;
  } else {
    storeName(item.id, *text);
  }
}

void Session::storeName(const std::string& item, const std::string& text) {
  study_.retryWithReservedSpace([&] { study_.identities().put(place(), item, text, utcNow()); });
  base::NamedArguments values{{"item", item}, {"kept_apart", std::int64_t{1}}};
  const auto fingerprint = fingerprintOf(study_, place(), item);
  if (!fingerprint.empty()) values.emplace_back("fingerprint", fingerprint);
  transact([&] { appendEvent(Actor::Participant, EventKind::Answered, values); });
}

void Session::storeHeldNames() {
  if (heldNames_.empty() || !gaveConsent()) return;
  for (const auto& [item, text] : heldNames_) storeName(item, text);
  heldNames_.clear();
}

void Session::retract(const std::string& id) {
  requireAnswerable();
  const auto item = askedItem(id);
  heldNames_.erase(id);
  if (item.isIdentifying)
    study_.retryWithReservedSpace([&] { study_.identities().remove(place(), id); });
  transact([&] {
    storage::AnswerRepository(study_.database()).remove(visit(), id);
    appendEvent(Actor::Participant, EventKind::Retracted, id);
  });
}

void Session::recordBenchmarkCuts(int cuts) {
  requireAnswerable();
  require(step().kind == StepKind::Benchmark, "No physical cuts are counted in this step.");
  require(cuts >= 0, "There cannot be fewer than no cuts.");
  transact([&] {
    const GivenAnswer answer{
        .item = kBenchmarkItem,
        .response = std::int64_t{cuts},
        .itemOrder = 1,
        .language = row_.language};
    storage::AnswerRepository(study_.database()).put(visit(), answer, utcNow());
    appendEvent(Actor::Participant, EventKind::Answered, storage::valuesOf(answer));
  });
}

int Session::benchmarkCuts() const {
  const auto answer = storage::AnswerRepository(study_.database()).find(visit(), kBenchmarkItem);
  return answer ? static_cast<int>(std::get<std::int64_t>(answer->response)) : 0;
}

bool Session::gaveConsent() const {
  const auto given = answers();
  const auto asked = items();
  return std::ranges::all_of(asked, [&](const auto& item) {
    if (item.consentOption.empty() || !item.isRequired) return true;
    return std::ranges::any_of(given, [&](const auto& answer) {
      return answer.item == item.id &&
             answer.response == questionnaires::Response(item.consentOption);
    });
  });
}

}  // namespace study
