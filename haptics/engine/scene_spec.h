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

/// The reamer of a scene: its speed, and how much its teeth can cut.
///
/// In every revolution each tooth cuts a chip of at most feedPerTooth, so the tool advances through
/// bone at most with
///
///     feed = speed · teeth · feedPerTooth,
///
/// as in the kinematics of milling. docs/decisions/0030-reaming-takes-time.md explains the
/// defaults.
struct Reamer {
  static constexpr double kMostSpeed = 100.0;  ///< in either direction [1/s]
  static constexpr double kLeastSpeed = 1e-6;  ///< of a reamer that turns [1/s]

  /// Revolutions per second, in [−100, 100]. Above 0 the teeth cut; below 0 the reamer turns
  /// backwards, and the teeth only rub. Unless 0, the size is at least kLeastSpeed, because with
  /// slower cutting the damping would overflow.
  double speed = 5.0;
  int teeth = 4;                 ///< teeth that pass each point of the surface per revolution, >= 1
  double feedPerTooth = 0.1e-3;  ///< [m], > 0; may be infinite
  bool hasTorque = true;         ///< false for studies of release 0.1, which rendered no torque

  /// The largest speed of advance through bone [m/s]; 0 if the reamer stands still or turns
  /// backwards.
  constexpr double mostFeed() const noexcept {
    return speed > 0.0 ? speed * teeth * feedPerTooth : 0.0;
  }

  /// Sign of the torque on the hand about the direction of advance: against the spin, since bone
  /// resists the teeth. 1, −1, or 0 if the reamer stands still or has no torque.
  constexpr int torqueSign() const noexcept {
    if (!hasTorque || speed == 0.0) return 0;
    return speed > 0.0 ? -1 : 1;
  }

  /// The cutting damping of this reamer [N·s/m]. The cutting force grows with the thickness of the
  /// chip, so the damping is inversely proportional to the number of teeth that pass per second.
  /// @param defaultDamping  damping of the default reamer, 20 teeth of which pass per second
  /// [N·s/m].
  constexpr double cuttingDampingOf(double defaultDamping) const noexcept {
    constexpr double kDefaultToothRate = 20.0;  // [1/s]
    return speed > 0.0 ? defaultDamping * (kDefaultToothRate / (speed * teeth)) : defaultDamping;
  }

  /// The reamer of release 0.1, without a limit of the feed and without torque.
  static constexpr Reamer withoutFeedLimit() noexcept {
    return {.feedPerTooth = std::numeric_limits<double>::infinity(), .hasTorque = false};
  }

  constexpr bool isSound() const noexcept {
    const double fast = speed < 0.0 ? -speed : speed;
    const bool isPossible = fast == 0.0 || (fast >= kLeastSpeed && fast <= kMostSpeed);
    return isPossible && teeth >= 1 && feedPerTooth > 0.0;
  }
};

/// Facts about a force model.
struct ModelInfo {
  std::string_view name;  ///< its name in protocols
  devices::Tissue tissue;
  std::string_view travelUnit;  ///< of the devices that can render it; empty: any device
};

/// Which branches of a recorded cut are rendered.
enum class Branches {
  ClosingOnly,  ///< opening follows the closing branch backwards, as in the punch paper
  Hysteresis,   ///< opening follows the recorded opening branch
};

/// Force by interpolation of a recorded cut: eq. (2) of the punch paper.
struct InterpolationSpec {
  static constexpr ModelInfo kInfo{"interpolation", devices::Tissue::Meniscus, "travel_unit"};

  std::vector<models::CurveNode<double>> curve;
  models::Interpolation<double>::Options options;
  Branches branches = Branches::ClosingOnly;
  std::vector<models::CurveNode<double>> opening;  ///< the opening branch, for Hysteresis
  /// Limit to which the slopes of the curves were reduced [N per travel unit].
  std::optional<double> slopeLimit;
  /// Travel over which the force changes between the branches [travel units], > 0.
  double transitionWidth = 0.5;
};

/// Force by one-dimensional finite elements: eq. (3)–(11) of the punch paper.
struct FiniteElementsSpec {
  static constexpr ModelInfo kInfo{"finite-elements", devices::Tissue::Meniscus, ""};

  models::FiniteElements<double>::Parameters parameters;
  std::vector<double> elementStiffnesses;  ///< one per element; empty: all are equal

  /// The parameters for the model. They point into this object, which must outlive the model.
  models::FiniteElements<double>::Parameters asParameters() const noexcept;
};

/// Interpolation and finite elements fused by a Kalman filter: eq. (12)–(24) of the punch paper.
struct KalmanSpec {
  static constexpr ModelInfo kInfo{"kalman", devices::Tissue::Meniscus, "travel_unit"};

  InterpolationSpec interpolation;
  FiniteElementsSpec finiteElements;
  models::KalmanNoise<double> noise;
  models::KalmanScheme scheme = models::KalmanScheme::AuthorsFirmware;
  bool isProcessAsPrinted = false;  ///< uses Q of eq. (22) with its misprint instead of noise
  models::Smoothing smoothing = models::Smoothing::None;
};

/// A node of a reaming material: forces and torques of the softest (lower) and hardest (upper)
/// bone.
struct MaterialNode {
  double depth = 0.0;        ///< [m]
  double lower = 0.0;        ///< [N]
  double upper = 0.0;        ///< [N]
  double lowerTorque = 0.0;  ///< about the tool's axis [N·m]
  double upperTorque = 0.0;  ///< [N·m]
};

/// Force over depth of an acetabulum, blended between a lower and an upper curve: (1 − h) · lower +
/// h · upper, both cubic Hermite splines with monotone-limited slopes; or between the three curves
/// of a fitted material. The torque is blended likewise.
struct MaterialSpec {
  static constexpr ModelInfo kInfo{"material", devices::Tissue::Bone, "m"};
  /// Stiffness between device and tool if bone is removed [N/m].
  static constexpr double kCoupling = 50'000.0;

  std::vector<MaterialNode> nodes;
  reaming::HardnessCurves curves;  ///< of a fitted material; if not empty, the nodes are not used
  reaming::HardnessCurves torque;  ///< of a fitted material [N·m]; empty if no torque was measured
  bool isMeasured = false;         ///< the curves were measured
  double hardness = 0.5;           ///< h, from 0 (lower curve) to 1 (upper curve)
  /// Factor of all forces and torques, in (0, 1], since an arm cannot render the full forces of
  /// bone.
  double forceScale = 1.0;
  /// If true, the reamer advances only as fast as it removes bone. If false, the force depends on
  /// depth only.
  bool isRemoved = false;
  reaming::Jitter jitter;        ///< noise, added while there is a force; rms 0: none
  std::uint64_t jitterSeed = 1;  ///< seed of the noise
};

/// Force of a bone of spheres along the axis of the reamer, with or without removal of bone.
struct PackingSpec {
  static constexpr ModelInfo kInfo{"packing", devices::Tissue::Bone, "m"};

  std::shared_ptr<const reaming::PackedBone> bone;
  double hardness = 0.5;    ///< h, from 0 (minimum curve) to 1 (maximum curve)
  double forceScale = 1.0;  ///< factor of all forces and torques, in (0, 1]
  bool isRemoved = true;    ///< the reamer removes the spheres that it passes through
  /// Options of removal, and the friction. The coverage is not used; it comes from the bone.
  reaming::BoneOptions options;
};

/// Every force model. A new model is added here; the compiler then reports every place that must
/// handle it.
using ModelSpec =
    std::variant<InterpolationSpec, FiniteElementsSpec, KalmanSpec, MaterialSpec, PackingSpec>;

const ModelInfo& infoOf(const ModelSpec& model) noexcept;

/// The parts of a model; nullptr for parts that it lacks. Valid as long as the model.
struct ModelParts {
  const InterpolationSpec* cut = nullptr;
  const FiniteElementsSpec* elements = nullptr;
  const KalmanSpec* filter = nullptr;
  const MaterialSpec* material = nullptr;
  const PackingSpec* packing = nullptr;
};
ModelParts partsOf(const ModelSpec& model) noexcept;

/// The travel at which the data of a model end [device's travel unit]: the last point of a cut plus
/// its ramp, or the last node of a material. std::nullopt for a model that has no such end.
std::optional<double> endOfData(const ModelSpec& model);

/// A discontinuity of the force at an end of a curve.
struct ForceJump {
  double travel = 0.0;  ///< [device's travel unit]
  double from = 0.0;    ///< before the jump, in the direction of closing [N]
  double to = 0.0;      ///< after the jump [N]
};

/// The force jumps of more than 0.05 N at the ends of a model's recorded cut (also of one that a
/// filter uses), which depend on the extrapolation, and at the first node of a material that is not
/// removed.
std::vector<ForceJump> jumpsOf(const ModelSpec& model);

/// A reaming model as a function of travel: without noise and without removal. std::nullopt for the
/// models of the punch.
std::optional<ModelSpec> withoutNoiseAndRemoval(const ModelSpec& model);

/// What determines the shape of the drawn meniscus, see MeshView.
enum class TissueDrawing {
  Penetration,  ///< the position of the tool, as in eq. (9) to (11) of the punch paper
  Force,        ///< the force at the handle: the tissue rises when the force falls
};

/// The finite elements with which a recorded cut is drawn: five equal ones, whose contact is where
/// the recorded force begins, and whose stiffness at the tool is the mean slope of the cut up to
/// its yield.
/// @param cut  valid, see problemsOf().
FiniteElementsSpec elementsMatching(const InterpolationSpec& cut);

/// What a condition renders and draws.
struct SceneSpec {
  ModelSpec model;
  bool isVisualised = false;
  TissueDrawing tissueDrawing = TissueDrawing::Penetration;
  Reamer reamer;  ///< used if bone is removed, and for the torque
};

/// Stiffness of the spring between device and tool if the model removes bone [N/m]; 0 for other
/// models.
double couplingOf(const ModelSpec& model);

/// The largest speed of the tool through the bone of @p spec [m/s]; infinite if no bone is removed.
double largestFeedOf(const SceneSpec& spec);

/// Whether the scene has a torque about the tool's axis.
bool hasTorque(const SceneSpec& spec);

/// Messages about all problems of @p spec; empty if it can be compiled.
std::vector<std::string> problemsOf(const SceneSpec& spec);

}  // namespace haptics::engine
