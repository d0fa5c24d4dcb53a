// What is asked in a step, and what has been answered.
#include <algorithm>
#include <utility>

#include "study/audit_words.h"
#include "study/session.h"
#include "study/storage/answer_repository.h"

namespace study {
namespace {

using storage::Actor;

constexpr const char* kBenchmarkItem = "physical-cuts";

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

std::vector<std::string> Session::missing() const {
  std::vector<questionnaires::Answer> given;
  for (auto& answer : answers()) given.push_back({answer.item, std::move(answer.response)});
  const auto asked = items();
  auto missing = questionnaires::unanswered(asked, given);
  const storage::IdentityStore::Place place{row_.participant, row_.number, row_.step, row_.attempt};
  std::erase_if(missing, [&](const std::string& id) {
    const auto item =
        std::find_if(asked.begin(), asked.end(), [&](const auto& i) { return i.id == id; });
    return item != asked.end() && item->isIdentifying && study_.identities().has(place, id);
  });
  return missing;
}

void Session::record(const GivenAnswer& answer) {
  const auto asked = items();
  const auto item =
      std::find_if(asked.begin(), asked.end(), [&](const auto& i) { return i.id == answer.item; });
  require(item != asked.end(), "'" + answer.item + "' is not asked in this step.");
  require(next(row_.state, SessionEvent::FinishedStep).has_value(), "Nothing can be answered now.");
  const auto objection = questionnaires::objection(*item, answer.response, step().alternatives);
  require(!objection, objection.value_or(""));
  if (item->isIdentifying) {
    storeIdentifying(*item, answer);
    return;
  }
  transact([&] {
    storage::AnswerRepository(study_.database()).put(visit(), answer, utcNow());
    say(Actor::Participant, "answered", auditWords(answer));
  });
}

void Session::storeIdentifying(const questionnaires::Item& item, const GivenAnswer& answer) {
  const auto* text = std::get_if<std::string>(&answer.response);
  require(text != nullptr, "'" + item.id + "' names a person and can only be a text.");
  study_.withRoom([&] {
    study_.identities().put(
        {row_.participant, row_.number, row_.step, row_.attempt}, item.id, *text, utcNow());
  });
  transact([&] { say(Actor::Participant, "answered", item.id + " (kept apart)"); });
}

void Session::retract(const std::string& item) {
  require(next(row_.state, SessionEvent::FinishedStep).has_value(), "Nothing can be answered now.");
  transact([&] {
    storage::AnswerRepository(study_.database()).remove(visit(), item);
    say(Actor::Participant, "retracted", item);
  });
}

void Session::recordBenchmarkCuts(int cuts) {
  require(step().kind == StepKind::Benchmark, "No physical cuts are counted in this step.");
  transact([&] {
    const GivenAnswer answer{
        .item = kBenchmarkItem,
        .response = std::int64_t{cuts},
        .itemOrder = 1,
        .language = row_.language};
    storage::AnswerRepository(study_.database()).put(visit(), answer, utcNow());
    say(Actor::Participant, "answered", auditWords(answer));
  });
}

int Session::benchmarkCuts() const {
  const auto answer = storage::AnswerRepository(study_.database()).find(visit(), kBenchmarkItem);
  return answer ? static_cast<int>(std::get<std::int64_t>(answer->response)) : 0;
}

bool Session::gaveConsent() const {
  const auto given = answers();
  const auto asked = items();
  return std::all_of(asked.begin(), asked.end(), [&](const auto& item) {
    if (item.consentOption.empty() || !item.isRequired) return true;
    return std::any_of(given.begin(), given.end(), [&](const auto& answer) {
      return answer.item == item.id &&
             answer.response == questionnaires::Response(item.consentOption);
    });
  });
}

}  // namespace study
