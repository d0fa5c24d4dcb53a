#pragma once

#include "haptics/models/finite_elements.h"
#include "haptics/models/interpolation.h"
#include "haptics/models/kalman_filter.h"

namespace haptics::firmware {

/// The parametric cut, haptics::recordings::parametricCut(), at 33 points: travel in travel units,
/// force in N. A test compares the table with parametricCut().
inline constexpr int kCutPoints = 33;
inline constexpr models::CurveNode<float> kCut[kCutPoints]{
    {2.000000f, 0.000000f},  {2.281250f, 0.000000f},  {2.562500f, 0.000000f},
    {2.843750f, 0.000000f},  {3.125000f, 0.000000f},  {3.406250f, 0.000000f},
    {3.687500f, 0.000000f},  {3.968750f, 0.033668f},  {4.250000f, 0.212925f},
    {4.531250f, 0.524420f},  {4.812500f, 0.938683f},  {5.093750f, 1.426580f},
    {5.375000f, 1.957969f},  {5.656250f, 2.502203f},  {5.937500f, 3.029814f},
    {6.218750f, 3.511330f},  {6.500000f, 3.917281f},  {6.781250f, 4.214922f},
    {7.062500f, 4.376547f},  {7.343750f, 4.363470f},  {7.625000f, 4.155688f},
    {7.906250f, 3.858906f},  {8.187500f, 3.598431f},  {8.468750f, 3.488603f},
    {8.750000f, 3.436339f},  {9.031250f, 3.378219f},  {9.312500f, 3.320001f},
    {9.593750f, 3.267534f},  {9.875000f, 3.226866f},  {10.156250f, 3.203666f},
    {10.437500f, 3.307580f}, {10.718750f, 3.976676f}, {11.000000f, 5.000000f},
};

/// A step of only the finite elements with their mesh, as in the published study.
template <int kElements>
class ElementsPunch {
 public:
  ElementsPunch() noexcept { elements_.writeMeshShape(shape_); }

  /// The force [N] at a travel [travel units].
  float step(float travel) noexcept {
    const float force = elements_.at(travel, state_).force;
    for (int i = 0; i < kElements; ++i) displacements_[i] = shape_[i] * force;
    return force;
  }

  const float* displacements() const noexcept { return displacements_; }  ///< [travel units]

 private:
  using Elements = models::FiniteElements<float>;

  static constexpr Elements::Parameters parameters() noexcept {
    Elements::Parameters p;
    p.elements = kElements;
    return p;
  }

  Elements elements_{parameters()};
  Elements::State state_;
  float shape_[kElements] = {};  ///< displacements for a force of 1 N [travel units]
  float displacements_[kElements] = {};
};

/// A full step of the punch in single precision, as in the published program: finite elements with
/// their mesh, interpolation, and two updates of the Kalman filter.
template <int kElements>
class FloatPunch {
 public:
  FloatPunch() noexcept { filter_.reset(); }

  /// The fused force [N] at a travel [travel units].
  float step(float travel) noexcept {
    const float elastic = elements_.step(travel);
    const float recorded = curve_.at(travel, hint_).force;
    const float travelled = hasTravel_ ? travel - last_ : 0.0F;
    last_ = travel;
    hasTravel_ = true;
    return filter_.step(travelled, elastic, recorded);
  }

  /// Displacements of the midpoints under the last force [travel units].
  const float* displacements() const noexcept { return elements_.displacements(); }

 private:
  ElementsPunch<kElements> elements_;
  models::Interpolation<float> curve_{kCut, kCutPoints, {}};
  size_t hint_ = 0;
  models::KalmanFilter<float> filter_{
      models::KalmanNoise<float>().factored(), models::KalmanScheme::AuthorsFirmware};
  float last_ = 0.0F;
  bool hasTravel_ = false;
};

/// A step of the interpolation, with finite elements for the mesh only.
template <int kElements>
class InterpolationPunch {
 public:
  /// The force [N] at a travel [travel units].
  float step(float travel) noexcept {
    elements_.step(travel);
    return curve_.at(travel, hint_).force;
  }

  const float* displacements() const noexcept {
    return elements_.displacements();
  }  ///< [travel units]

 private:
  ElementsPunch<kElements> elements_;
  models::Interpolation<float> curve_{kCut, kCutPoints, {}};
  size_t hint_ = 0;
};

}  // namespace haptics::firmware
