#include "study/session/session_length.h"

#include <algorithm>
#include <cmath>
#include <sstream>

#include "protocols/orders/schedule.h"

namespace study {
namespace {

using questionnaires::ItemType;

double secondsToRead(const questionnaires::LocalizedText& text, const Pace& pace) {
  std::istringstream stream(text.in("en"));
  double words = 0.0;
  for (std::string word; stream >> word;) {
    const bool isMarkOfHeading = word.find_first_not_of('#') == std::string::npos;
    words += isMarkOfHeading ? 0.0 : 1.0;
  }
  return words / pace.wordsPerSecond;
}

double secondsToAnswer(const questionnaires::Item& item, const Pace& pace) {
  const bool isText = item.type == ItemType::ShortText || item.type == ItemType::LongText;
  return isText ? pace.perText : pace.perItem;
}

void add(std::vector<PartOfSession>& parts, const PartOfSession& part) {
  const auto found = std::ranges::find(parts, part.kind, &PartOfSession::kind);
  if (found == parts.end()) {
    parts.push_back(part);
    return;
  }
  found->steps += part.steps;
  found->items += part.items;
  found->cuts += part.cuts;
  found->seconds += part.seconds;
  found->secondsOnDevice += part.secondsOnDevice;
}

}  // namespace

PartOfSession partOf(const protocols::LoadedProtocol& loaded, const Step& step, const Pace& pace) {
  PartOfSession part{.kind = step.kind, .steps = 1, .seconds = step.seconds};
  if (step.kind == StepKind::Trial || step.kind == StepKind::Benchmark) {
    part.cuts = std::max(step.minimumCuts, 1);
    const double touching = part.cuts * pace.perCut;
    part.seconds += touching + pace.perPreparation;
    if (step.kind == StepKind::Trial) part.secondsOnDevice = touching;
  }
  const auto* instrument = step.hasItems() ? loaded.instrument(step.instrument) : nullptr;
  if (instrument == nullptr) return part;
  // The introduction is read the first time only: at the first position of a block.
  const bool isKnown = step.kind == StepKind::Questionnaire && step.position > 1;
  if (!isKnown) part.seconds += secondsToRead(instrument->introduction, pace);
  for (const auto& item : instrument->itemsOf(step.itemSet)) {
    ++part.items;
    part.seconds += secondsToAnswer(item, pace);
  }
  return part;
}

SessionLength lengthOf(const protocols::LoadedProtocol& loaded, const Pace& pace) {
  const auto& protocol = loaded.protocol;
  const auto schedule =
      protocols::scheduleFor(protocol, protocol.seed.value_or(1), protocol.cohorts.front().id, 0);
  SessionLength length;
  for (const auto& step : sessionPlan(protocol, schedule)) {
    if (step.isOptionalTrial) continue;  // few participants accept the offer
    const auto part = partOf(loaded, step, pace);
    add(length.parts, part);
    length.seconds += part.seconds;
    length.secondsOnDevice += part.secondsOnDevice;
  }
  return length;
}

int minutesOf(double seconds) {
  return static_cast<int>(std::ceil(seconds / 60.0));
}

}  // namespace study
