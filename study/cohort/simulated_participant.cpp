#include "study/cohort/simulated_participant.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

namespace study {
namespace {

using questionnaires::AnswerKind;
using questionnaires::Item;
using questionnaires::Response;

constexpr double kOmissionProbability = 0.3;  // probability that an optional item is left out

// Standard deviation of the noise of a choice between alternatives, relative to the noise of an
// answer. An assumption, not a measurement: a person who has felt all alternatives compares them
// directly, so choices follow realism more closely than answers do.
constexpr double kNoiseOfAChoice = 0.5;

}  // namespace

SimulatedParticipant::SimulatedParticipant(
    const protocols::SimulatedAnswerModel& answerModel,
    std::uint64_t seed,
    std::string cohort,
    std::uint64_t slot)
    : answerModel_(answerModel), seed_(seed), cohort_(std::move(cohort)), slot_(slot) {}

base::RandomStream SimulatedParticipant::stream(const std::string& purpose) const {
  return {seed_, slot_, "simulated/" + cohort_ + "/" + purpose};
}

double SimulatedParticipant::secondsFor(const std::string& what, double least, double most) const {
  // Whole milliseconds, the resolution of a study's clock.
  return std::round(stream("seconds/" + what).uniform(least, most) * 1000.0) / 1000.0;
}

double SimulatedParticipant::realismOf(const std::string& condition) const {
  return answerModel_.realismOf(condition) +
         answerModel_.participantStandardDeviation * stream("leniency").normal() +
         answerModel_.interactionStandardDeviation * stream("taste/" + condition).normal();
}

std::int64_t SimulatedParticipant::drawPoint(
    const Session& session, const Item& item, const std::string& purpose) const {
  const double realism =
      session.step().condition.empty() ? 0.0 : realismOf(session.step().condition);
  const double felt = realism + answerModel_.residualStandardDeviation * stream(purpose).normal();
  // realism is defined on a five-point scale
  const double unit = (item.scale.points - 1) / 4.0;
  const double middle = (item.scale.lowest + item.scale.highest()) / 2.0;
  const double answer = middle + item.key * unit * felt;
  return std::clamp<std::int64_t>(std::llround(answer), item.scale.lowest, item.scale.highest());
}

double SimulatedParticipant::drawSliderValue(
    const Session& session, const Item& item, const std::string& purpose) const {
  const double felt = realismOf(session.step().condition) +
                      answerModel_.residualStandardDeviation * stream(purpose).normal();
  const double unit = (item.most - item.least) / 4.0;  // realism is defined on a five-point scale
  const double answer = std::clamp(
      std::midpoint(item.least, item.most) + item.key * unit * felt, item.least, item.most);
  const double step = item.step > 0.0 ? item.step : 1.0;
  const double steps = std::floor((item.most - item.least) / step + 1e-9);
  return item.least + step * std::min(steps, std::round((answer - item.least) / step));
}

std::string SimulatedParticipant::drawPreferredLabel(
    const Session& session, const std::string& purpose) const {
  std::string best;
  double most = -1e300;
  const auto labels = session.alternatives();
  for (const auto& step : session.plan()) {
    const auto* phase = session.protocol().protocol.phase(session.step().phase);
    const std::string label = std::to_string(step.label);
    const bool isChoice = step.kind == StepKind::Trial && phase != nullptr &&
                          step.phase == phase->block &&
                          std::ranges::find(labels, label) != labels.end();
    if (!isChoice) continue;
    const double deviation = kNoiseOfAChoice * answerModel_.residualStandardDeviation;
    const double felt =
        realismOf(step.condition) + deviation * stream(purpose + "/" + label).normal();
    if (felt > most) {
      most = felt;
      best = label;
    }
  }
  return best;
}

std::optional<Response> SimulatedParticipant::answer(
    const Session& session, const Item& item) const {
  const std::string purpose =
      "answer/" + session.step().phase + "/" + session.step().condition + "/" + item.id;
  auto random = stream(purpose + "/choice");
  if (!item.isRequired && random.uniform() < kOmissionProbability) return std::nullopt;
  switch (questionnaires::answerKindOf(item.type)) {
    case AnswerKind::Point:
      return drawPoint(session, item, purpose);
    case AnswerKind::Number: {
      if (item.type == questionnaires::ItemType::Slider && !session.step().condition.empty()) {
        return drawSliderValue(session, item, purpose);
      }
      const double share = std::clamp(0.45 + 0.18 * random.normal(), 0.0, 1.0);
      const double step = item.step > 0.0 ? item.step : 1.0;
      const double steps = std::floor((item.most - item.least) / step + 1e-9);
      return item.least + step * std::round(share * steps);
    }
    case AnswerKind::Option:
      if (!item.consentOption.empty()) return item.consentOption;
      if (item.optionSource == questionnaires::OptionSource::Alternatives) {
        return drawPreferredLabel(session, purpose);
      }
      return item.options[random.below(item.options.size())].id;
    case AnswerKind::Options:
      return std::vector<std::string>{item.options[random.below(item.options.size())].id};
    case AnswerKind::Text:
      return std::string("simulated");
  }
  return std::nullopt;
}

}  // namespace study
