#pragma once

#include "haptics/models/finite_elements.h"
#include "haptics/models/interpolation.h"
#include "haptics/models/kalman_filter.h"
#include "haptics/wire/crc32.h"
#include "haptics/wire/punch_codec.h"

namespace haptics::firmware {

/// A scene that the punch renders itself: the engine's models in single precision, with parameters
/// received from the host. It is ready when all parameters have arrived and are valid.
class OnDeviceScene {
 public:
  /// Begins a new scene with @p model, whose payload is @p bytes.
  wire::punch::ModelVerdict take(
      const wire::punch::Model& model, const uint8_t* bytes, size_t count) noexcept {
    model_ = model;
    points_ = 0;
    isReady_ = false;
    hash_ = wire::crc32(bytes, count);
    return finish();
  }

  /// Adds the next points of the curve; their payload is @p bytes.
  wire::punch::ModelVerdict take(
      const wire::punch::ModelTable& table, const uint8_t* bytes, size_t count) noexcept {
    using wire::punch::ModelVerdict;
    if (table.first != points_ || points_ + table.count > model_.tableSize) {
      return ModelVerdict::Incomplete;
    }
    for (int i = 0; i < table.count; ++i) table_[points_++] = {table.travel[i], table.force[i]};
    hash_ = wire::crc32(bytes, count, hash_);
    return finish();
  }

  bool isReady() const noexcept { return isReady_; }
  uint32_t hash() const noexcept { return hash_; }

  /// Resets the state of the models.
  void reset() noexcept {
    elementsState_ = {};
    hint_ = 0;
    hasTravel_ = false;
    filter_.reset();
  }

  /// The voltage [mV] of the resisting force at @p counts of the encoder; 0 if the force is
  /// undefined.
  int32_t millivoltsAt(int32_t counts) noexcept {
    const float force = forceAt(travelAt(counts));
    const float bounded = force > model_.largestForce    ? model_.largestForce
                          : force < -model_.largestForce ? -model_.largestForce
                                                         : force;
    if (!wire::punch::isFinite(bounded)) return 0;
    // [mV], far beyond any motor; larger values could overflow an integer.
    constexpr float kMostMillivolts = 1e6F;
    const float millivolts = bounded * model_.millivoltsPerNewton;
    return static_cast<int32_t>(
        millivolts > kMostMillivolts    ? kMostMillivolts
        : millivolts < -kMostMillivolts ? -kMostMillivolts
                                        : millivolts);
  }

  /// Travel at @p counts of the encoder [travel units].
  float travelAt(int32_t counts) const noexcept {
    return model_.travelAtZero + model_.travelPerCount * static_cast<float>(counts);
  }

  /// Force at @p travel [travel units] [N]; changes the models' state.
  float forceAt(float travel) noexcept {
    using wire::punch::ModelKind;
    switch (model_.kind) {
      case ModelKind::Interpolation:
        return curve_.at(travel, hint_).force;
      case ModelKind::FiniteElements:
        return elements_.at(travel, elementsState_).force;
      case ModelKind::Kalman:
        return fusedForce(travel);
      case ModelKind::None:
        break;
    }
    return 0.0F;
  }

 private:
  using Elements = models::FiniteElements<float>;
  using Curve = models::Interpolation<float>;
  using Filter = models::KalmanFilter<float>;

  float fusedForce(float travel) noexcept {
    const float recorded = curve_.at(travel, hint_).force;
    const float elastic = elements_.at(travel, elementsState_).force;
    const float travelled = hasTravel_ ? travel - last_ : 0.0F;
    last_ = travel;
    hasTravel_ = true;
    const float force =
        filter_.step(travelled, elastic, recorded, curve_.measurementWeightAt(travel));
    if (wire::punch::isFinite(force)) return force;
    reset();  // only an impossible motion causes this
    return 0.0F;
  }

  Elements::Parameters elementParameters() const noexcept {
    Elements::Parameters p;
    p.start = model_.start;
    p.end = model_.end;
    p.elements = model_.elements;
    p.elementStiffness = model_.elementStiffness;
    p.toolPosition = model_.toolPosition;
    p.contact = model_.contact;
    p.yieldForce = model_.yieldForce;
    p.boundary = static_cast<models::BoundaryCondition>(model_.equationVariants & 1U);
    p.weights = static_cast<models::ToolInterpolation>((model_.equationVariants >> 1U) & 3U);
    p.yielding = static_cast<models::YieldLaw>((model_.equationVariants >> 3U) & 1U);
    return p;
  }

  models::KalmanNoise<float> noise() const noexcept {
    return {
        model_.noise[0],
        model_.noise[1],
        model_.noise[2],
        model_.noise[3],
        model_.noise[4],
        model_.noise[5]};
  }

  /// Creates the models if all parameters have arrived.
  wire::punch::ModelVerdict finish() noexcept {
    using wire::punch::ModelKind;
    using wire::punch::ModelVerdict;
    if (model_.kind == ModelKind::None) return ModelVerdict::Accepted;
    const bool hasCurve = model_.kind != ModelKind::FiniteElements;
    const bool hasElements = model_.kind != ModelKind::Interpolation;
    if (hasCurve && points_ < model_.tableSize) return ModelVerdict::Incomplete;
    const Curve::Options options{
        static_cast<models::Extrapolation>(model_.extrapolation), model_.rampLength};
    const auto count = static_cast<size_t>(points_);
    const auto parameters = elementParameters();
    const bool isWeighing = ((model_.equationVariants >> 1U) & 3U) <= 2U;
    const bool isSound = (!hasCurve || Curve::isSound(table_, count, options)) &&
                         (!hasElements || (isWeighing && Elements::isSound(parameters))) &&
                         (model_.kind != ModelKind::Kalman || noise().invalidReason() == nullptr) &&
                         model_.largestForce >= 0.0F;
    if (!isSound) return ModelVerdict::InvalidModel;
    if (hasCurve) curve_ = Curve(table_, count, options);
    if (hasElements) elements_ = Elements(parameters);
    if (model_.kind == ModelKind::Kalman) {
      filter_ = Filter(noise().factored(), static_cast<models::KalmanScheme>(model_.scheme));
    }
    reset();
    isReady_ = true;
    return ModelVerdict::Accepted;
  }

  wire::punch::Model model_;
  models::CurveNode<float> table_[wire::punch::kLargestTable];
  int points_ = 0;
  bool isReady_ = false;
  uint32_t hash_ = 0;

  Curve curve_{table_, 0, {}};
  Elements elements_{Elements::Parameters()};
  Elements::State elementsState_;
  Filter filter_{models::KalmanNoise<float>().factored(), models::KalmanScheme::AuthorsFirmware};
  size_t hint_ = 0;
  float last_ = 0.0F;
  bool hasTravel_ = false;
};

}  // namespace haptics::firmware
