#include "tests/study/walk.h"

#include "base/joined.h"

namespace tests {
namespace {

using questionnaires::Item;
using questionnaires::ItemType;

questionnaires::Response firstAllowed(const study::Session& session, const Item& item) {
  switch (item.type) {
    case ItemType::Likert:
    case ItemType::SemanticDifferential:
      return std::int64_t{item.scale.lowest};
    case ItemType::Slider:
    case ItemType::Number:
      return item.least;
    case ItemType::MultipleChoice:
      return std::vector<std::string>{item.options.front().id};
    case ItemType::ShortText:
    case ItemType::LongText:
      return std::string("some words");
    case ItemType::SingleChoice:
    case ItemType::PairwiseChoice:
      break;
  }
  if (!item.consentOption.empty()) return item.consentOption;
  const bool isAlternative = item.optionSource == questionnaires::OptionSource::Alternatives;
  return isAlternative ? session.alternatives().front() : item.options.front().id;
}

}  // namespace

study::GivenAnswer answerTo(const study::Session& session, const Item& item, int order) {
  return {
      .item = item.id,
      .response = firstAllowed(session, item),
      .itemOrder = order,
      .firstTouch = 1.0,
      .responseTime = 2.0,
      .changes = 0,
      .language = session.language()};
}

void answerStep(study::Session& session, bool all) {
  int order = 0;
  for (const auto& item : session.items()) {
    ++order;
    if (item.isRequired || all) session.record(answerTo(session, item, order));
  }
}

study::TrialRecord feltTrial(int cuts) {
  study::TrialRecord record{.device = "simulated punch", .travelUnit = "travel_unit"};
  record.cuts.resize(static_cast<std::size_t>(cuts));
  return record;
}

void passStep(study::Session& session) {
  const auto& step = session.step();
  if (step.kind == study::StepKind::Trial) {
    session.beginTrial();
    session.finishTrial(feltTrial(step.minimumCuts));
    return;
  }
  if (step.kind == study::StepKind::Benchmark) session.recordBenchmarkCuts(step.minimumCuts);
  answerStep(session);
  session.finishStep();
}

void walkUntil(study::Session& session, const std::function<bool(const study::Step&)>& isThere) {
  while (!session.isOver() && !isThere(session.step())) passStep(session);
}

void walkTo(study::Session& session, study::StepKind kind) {
  walkUntil(session, [kind](const study::Step& step) { return step.kind == kind; });
}

void walkToTheEnd(study::Session& session) {
  walkUntil(session, [](const study::Step&) { return false; });
}

study::Session consenting(study::Study& study, const study::Enrolment& enrolment) {
  auto session = study::Session::enrol(study, enrolment);
  while (session.state() == study::SessionState::Enrolled) passStep(session);
  return session;
}

std::string eventsOf(study::Study& study, study::SessionId session) {
  return base::joined(
      study.events().read(session), " ", [](const auto& event) { return event.name(); });
}

}  // namespace tests
