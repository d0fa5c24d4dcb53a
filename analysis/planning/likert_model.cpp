#include "analysis/planning/likert_model.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>

namespace analysis {
namespace {

constexpr double kThresholdDistance = 0.8;

/// In (0, 1], from the upper 53 bits.
double uniform(std::mt19937_64& random) {
  return (static_cast<double>(random() >> 11U) + 1.0) * 0x1p-53;
}

}  // namespace

double LikertModel::levelOfFirst() const {
  return dz * std::sqrt(2.0 * (participantByConditionShare + residualShare / answers));
}

void LikertModel::check() const {
  const double least = std::min({participantShare, participantByConditionShare, residualShare});
  const double sum = participantShare + participantByConditionShare + residualShare;
  if (!(least >= 0.0 && std::abs(sum - 1.0) < 1e-9)) {
    throw std::invalid_argument("shares of the variance are not negative and add up to one");
  }
  if (points < 2 || conditions < 2 || answers < 1 || !std::isfinite(dz)) {
    throw std::invalid_argument("a model has two points, two conditions, an answer and an effect");
  }
}

LikertCohort::LikertCohort(const LikertModel& model, std::uint64_t seed)
    : model_((model.check(), model)), levelOfFirst_(model.levelOfFirst()), random_(seed) {}

double LikertCohort::normal() {
  hasSpare_ = !hasSpare_;
  if (!hasSpare_) return spare_;
  const double radius = std::sqrt(-2.0 * std::log(uniform(random_)));
  const double angle = 2.0 * std::numbers::pi * uniform(random_);
  spare_ = radius * std::sin(angle);
  return radius * std::cos(angle);
}

int LikertCohort::pointAt(double x) const {
  const double middle = 0.5 * (model_.points + 1);
  const double point = std::floor(x / kThresholdDistance + middle + 0.5);
  return static_cast<int>(std::clamp(point, 1.0, static_cast<double>(model_.points)));
}

LikertAnswers LikertCohort::next() {
  const double ofPerson = std::sqrt(model_.participantShare) * normal();
  LikertAnswers answers;
  for (int c = 0; c < model_.conditions; ++c) {
    const double level = (c == 0 ? levelOfFirst_ : 0.0) + ofPerson +
                         std::sqrt(model_.participantByConditionShare) * normal();
    auto& ofCondition = answers.emplace_back();
    for (int i = 0; i < model_.answers; ++i) {
      ofCondition.push_back(pointAt(level + std::sqrt(model_.residualShare) * normal()));
    }
  }
  return answers;
}

}  // namespace analysis
