#pragma once

#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "haptics/devices/device_kind.h"
#include "haptics/models/finite_elements.h"
#include "haptics/models/interpolation.h"
#include "haptics/models/kalman_filter.h"
#include "haptics/models/smoothing.h"
#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/material/material.h"

namespace haptics::reaming {
struct PackedBone;
}

namespace haptics::engine {

/// The cutting tool of a scene: how fast it turns, and how much its teeth can take.
///
/// In every turn each tooth takes a chip of at most feedPerTooth, so that the tool advances through
/// bone no faster than
///
///     feed = speed · teeth · feedPerTooth,
///
/// the kinematics of milling. docs/decisions/0030-reaming-takes-time.md argues the defaults.
struct Reamer {
  static constexpr double kMostSpeed = 100.0;  ///< either way [1/s]

  /// Turns in a second, in [−100, 100]; the sign is the spin: above 0 the teeth cut, below 0 their
  /// backs rub.
  double speed = 5.0;
  int teeth = 4;                 ///< that pass each place of the surface in one turn, >= 1
  double feedPerTooth = 0.1e-3;  ///< [m], > 0; may be infinite
  bool hasTorque = true;         ///< release 0.1 rendered forces alone

  /// How fast it can go through bone [m/s]; 0 where it stands still or turns backwards.
  constexpr double mostFeed() const noexcept {
    return speed > 0.0 ? speed * teeth * feedPerTooth : 0.0;
  }

  /// The direction of the torque on the hand about the way of advancing: bone holds the teeth, so
  /// it is against the spin. 1, −1, or 0 where the reamer stands still.
  constexpr int torqueSign() const noexcept {
    if (!hasTorque || speed == 0.0) return 0;
    return speed > 0.0 ? -1 : 1;
  }

  /// A force grows with the thickness of the chip, so that a cutting damping falls with the teeth
  /// that pass in a second.
  /// @param stated  that of the default reamer, whose teeth pass 20 times a second [N·s/m].
  constexpr double dampingOf(double stated) const noexcept {
    constexpr double kPassesOfTheDefault = 20.0;  // [1/s]
    return speed > 0.0 ? stated * (kPassesOfTheDefault / (speed * teeth)) : stated;
  }

  /// That of release 0.1, which removed all that it was pushed through.
  static constexpr Reamer withoutLimit() noexcept {
    return {.feedPerTooth = std::numeric_limits<double>::infinity(), .hasTorque = false};
  }

  constexpr bool isSound() const noexcept {
    return speed >= -kMostSpeed && speed <= kMostSpeed && teeth >= 1 && feedPerTooth > 0.0;
  }
};

/// What is registered about a force model.
struct ModelFacts {
  std::string_view name;  ///< in protocols
  devices::Tissue tissue;
  std::string_view travelUnit;  ///< of the devices that it can be felt on; empty: any
};

/// Which branches of a recorded cut are felt.
enum class Branches {
  ClosingOnly,  ///< opening goes back along the closing branch, as in the punch paper
  Hysteresis,   ///< opening follows the recorded opening branch
};

/// Force by interpolation of a recorded cut: eq. (2) of the punch paper.
struct InterpolationSpec {
  static constexpr ModelFacts kFacts{"interpolation", devices::Tissue::Meniscus, "travel_unit"};

  std::vector<models::CurveNode<double>> curve;
  models::Interpolation<double>::Options options;
  Branches branches = Branches::ClosingOnly;
  std::vector<models::CurveNode<double>> opening;  ///< the opening branch, for Hysteresis
  std::optional<double> slopeLimit;  ///< that the curves were made to keep [N per travel unit]
  double turningWidth = 0.5;         ///< of travel from one branch to the other [travel units], > 0
};

/// Force by one-dimensional finite elements: eq. (3)–(11) of the punch paper.
struct FiniteElementsSpec {
  static constexpr ModelFacts kFacts{"finite-elements", devices::Tissue::Meniscus, ""};

  models::FiniteElements<double>::Parameters parameters;
  std::vector<double> elementStiffnesses;  ///< of each element, if they differ; or empty

  /// For the model; this must outlive it.
  models::FiniteElements<double>::Parameters asParameters() const noexcept;
};

/// Both fused by a Kalman filter: eq. (12)–(24) of the punch paper.
struct KalmanSpec {
  static constexpr ModelFacts kFacts{"kalman", devices::Tissue::Meniscus, "travel_unit"};

  InterpolationSpec interpolation;
  FiniteElementsSpec finiteElements;
  models::KalmanNoise<double> noise;
  models::KalmanScheme scheme = models::KalmanScheme::AuthorsFirmware;
  bool isProcessAsPrinted = false;  ///< Q of eq. (22) with its misprint, in place of the noise
  models::Smoothing smoothing = models::Smoothing::None;
};

/// A node of a reaming material: the softest and the hardest bone that there is.
struct MaterialNode {
  double depth = 0.0;        ///< [m]
  double lower = 0.0;        ///< [N]
  double upper = 0.0;        ///< [N]
  double lowerTorque = 0.0;  ///< about the tool's axis [N·m]
  double upperTorque = 0.0;  ///< [N·m]
};

/// Force over displacement of an acetabulum, between a lower and an upper curve:
/// (1 − h) · lower + h · upper, both cubic Hermite splines with monotone-limited slopes; or between
/// the three curves of a fitted material; and so the torque.
struct MaterialSpec {
  static constexpr ModelFacts kFacts{"material", devices::Tissue::Bone, "m"};
  static constexpr double kCoupling = 50'000.0;  ///< to the tool in bone that is removed [N/m]

  std::vector<MaterialNode> nodes;
  reaming::HardnessCurves curves;  ///< of a fitted material, instead of the nodes
  reaming::HardnessCurves torque;  ///< of a fitted material [N·m]; empty where none was measured
  bool isMeasured = false;         ///< the curves were measured
  double hardness = 0.5;           ///< h, from 0 (lower curve) to 1 (upper curve)
  /// Bone asks for more than an arm gives: forces and torques times this, in (0, 1].
  double forceScale = 1.0;
  /// The reamer goes on as it removes bone, at its own feed; otherwise the force is a function of
  /// depth, however fast the tool is.
  bool isRemoved = false;
  reaming::Jitter jitter;        ///< added as noise while there is a force; rms 0: none
  std::uint64_t jitterSeed = 1;  ///< the same seed, the same noise
};

/// A bone of spheres, felt along the axis of its plunge: as it is, or as the reamer leaves it.
struct PackingSpec {
  static constexpr ModelFacts kFacts{"packing", devices::Tissue::Bone, "m"};

  std::shared_ptr<const reaming::PackedBone> bone;
  double hardness = 0.5;    ///< h, from 0 (minimum curve) to 1 (maximum curve)
  double forceScale = 1.0;  ///< forces and torques times this, in (0, 1]
  bool isRemoved = true;    ///< the reamer removes the spheres that it passes through
  double mostTravel = 0.0;  ///< how deep the device goes [m]; 0: through the bone
  /// Of a bone that is cut, and the friction of any; the coverage is the bone's own.
  reaming::BoneOptions options;
};

/// Every force model that there is. One that is added is registered here; the compiler then points
/// to everything that has to be said about it.
using ModelSpec =
    std::variant<InterpolationSpec, FiniteElementsSpec, KalmanSpec, MaterialSpec, PackingSpec>;

const ModelFacts& factsOf(const ModelSpec& model) noexcept;

/// The parts of a model; nullptr for those that it does not have. They live as long as the model.
struct ModelParts {
  const InterpolationSpec* cut = nullptr;
  const FiniteElementsSpec* elements = nullptr;
  const KalmanSpec* filter = nullptr;
  const MaterialSpec* material = nullptr;
  const PackingSpec* packing = nullptr;
};
ModelParts partsOf(const ModelSpec& model) noexcept;

/// Where the data of a model end: a cut's last point and its ramp, a material's last node [device's
/// travel unit]. std::nullopt for a model that has no end of its own.
std::optional<double> endOfData(const ModelSpec& model);

/// A place where the force of a recorded cut changes at once, because its curve ends there.
struct ForceJump {
  double travel = 0.0;  ///< [device's travel unit]
  double from = 0.0;    ///< before it, when the hand closes [N]
  double to = 0.0;      ///< after it [N]
};

/// Where the recorded cut of a model, or the one that its filter uses, begins or ends with a force
/// that its policy does not continue, by more than 0.05 N. Empty for a model without a cut.
std::vector<ForceJump> jumpsOf(const ModelSpec& model);

/// The model as a curve over travel, without noise and before removal. std::nullopt if its force
/// depends on more than travel, or comes from a recording.
std::optional<ModelSpec> undisturbed(const ModelSpec& model);

/// What the meniscus that is seen follows: MeshView.
enum class SeenTissue {
  Penetration,  ///< the tool, as eq. (9) to (11) of the punch paper have it
  Force,        ///< the force at the handle: tissue rises again where that falls
};

/// The elements whose mesh shows a recorded cut: five alike, which begin to give way where the
/// recorded force begins and are as stiff at the tool as the cut is on the way to its yield.
/// @param cut  valid, see problemsOf().
FiniteElementsSpec elementsLike(const InterpolationSpec& cut);

/// Everything that is rendered and shown in a condition.
struct SceneSpec {
  ModelSpec model;
  bool isVisualised = false;
  SeenTissue seenTissue = SeenTissue::Penetration;
  Reamer reamer;  ///< of bone that is removed
};

/// Of the spring between the device and the tool in bone that is removed [N/m]; 0 for another
/// model.
double couplingOf(const ModelSpec& model);

/// How fast the tool can move through the bone of @p spec [m/s]; infinite for a scene in which no
/// bone is removed.
double feedLimitOf(const SceneSpec& spec);

/// Whether the scene may have a torque about the tool's axis.
bool hasTorque(const SceneSpec& spec);

/// All problems of @p spec, in words; empty if it can be compiled.
std::vector<std::string> problemsOf(const SceneSpec& spec);

}  // namespace haptics::engine
