#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "haptics/reaming/bone/sphere_field.h"

namespace haptics::reaming {

/// Parameters of a bone with removal.
struct BoneOptions {
  double coverage = 1.0;  ///< of the packing; contact areas are divided by it, (0, 1]
  /// Stiffness of the spring between the device and the virtual tool [N/m], > 0.
  double coupling = 50'000.0;
  /// Increase of the force with the speed of advance [N·s/m], >= 0.
  double cuttingDamping = 2000.0;
  double friction = 0.1;      ///< coefficient of friction between tool and bone, >= 0
  double mostAdvance = 5e-5;  ///< largest advance through bone in one step [m], (0, 0.01]
  /// Largest speed of advance through bone, which the teeth allow however hard the tool is pushed
  /// [m/s], >= 0.
  double mostFeed = std::numeric_limits<double>::infinity();
  bool isGuided = false;   ///< the reamer only moves along its axis, as in a testing machine
  bool isSpinning = true;  ///< turns forwards; otherwise the teeth do not cut
};

/// A bone of spheres that a reamer removes.
///
/// The virtual tool is held by the bone (a constrained tool, as in the reaming paper). It advances
/// only while the coupling to the device pushes harder than the resistance F = Σ aρ / coverage of
/// the spheres in contact, and no faster than its teeth allow. It removes the spheres behind its
/// surface, each within eight steps. A sphere is cut slice by slice; when the tool has left it, the
/// remainder is replaced by smaller spheres inside it, with the remaining mass (density × volume).
/// All removed mass is counted.
///
/// The time of a step is bounded; it does not allocate or throw.
class Bone {
 public:
  /// @throws std::invalid_argument  if packing, densities or options are not valid.
  Bone(const Packing& packing, std::span<const double> densities, const BoneOptions& options);

  struct StepForce {
    Vec3 force;  ///< on the hand [N]
    /// Torque of friction on a turning reamer, against its spin [N·m]
    double frictionTorque = 0.0;
    ReamerContact contact;  ///< of the virtual tool
    /// False if the device's position is NaN, or was inside the bone at the beginning.
    bool isDefined = false;
  };

  /// Advances by @p dt [s] with the device at @p device, and returns the force.
  StepForce step(const Reamer& device, double dt) noexcept;

  /// Sets whether the teeth cut from the next step on; initially BoneOptions::isSpinning.
  void setSpinning(bool isSpinning) noexcept { isSpinning_ = isSpinning; }

  /// Restores the whole bone, over the next steps; until then there is no force.
  void reset() noexcept;

  const Reamer& tool() const noexcept { return tool_; }  ///< the virtual tool
  const SphereField& field() const noexcept { return field_; }
  double coverage() const noexcept { return options_.coverage; }

  double removedMass() const noexcept { return removedMass_; }  ///< [N·m]
  double remainingMass() const noexcept;  ///< sums over all spheres: slow [N·m]

  /// Slots that the last step emptied, shrank, moved or filled, for drawing.
  std::span<const std::uint32_t> changed() const noexcept { return changed_; }
  /// Number of changes that did not fit into the list.
  std::uint64_t droppedChanges() const noexcept { return droppedChanges_; }
  /// Whether the device is known to have been outside all spheres since construction or reset().
  /// Until then every step checks some of the spheres.
  bool isOutside() const noexcept { return isOutside_; }
  /// How often the bone has been restored.
  std::uint64_t restorations() const noexcept { return restorations_; }

 private:
  bool restorePart() noexcept;
  bool isClear() noexcept;
  Vec3 outwardOf(const ReamerContact& contact) const noexcept;
  void moveTool(const Reamer& device, const ReamerContact& contact, Vec3 out, double dt) noexcept;
  Vec3 slideOf(Vec3 gap, Vec3 out, double push) const noexcept;
  void cut() noexcept;
  void cutSlot(std::uint32_t slot) noexcept;
  void replaceLeftSpheres() noexcept;
  bool hasToolLeft(std::uint32_t slot) const noexcept;
  void splitRemainder(std::uint32_t slot) noexcept;
  double massOf(std::uint32_t slot) const noexcept;
  void empty(std::uint32_t slot) noexcept;
  void noteChange(std::uint32_t slot) noexcept;

  BoneOptions options_;
  bool isSpinning_;
  SphereField field_;
  SphereField intactField_;
  std::vector<Vec3> toolAtLastCut_;          ///< position of the tool when it last cut the slot
  std::vector<std::uint32_t> partialSlots_;  ///< slots that are partly cut
  std::vector<char> isPartial_;
  std::vector<std::uint32_t> slotsToCut_;  ///< buffer for the slots that a step cuts
  std::vector<std::uint32_t> changed_;
  std::uint64_t droppedChanges_ = 0;
  std::uint64_t restorations_ = 0;
  std::size_t pending_ = 0;         ///< steps until all spheres behind the surface are cut
  std::size_t nextPart_ = 0;        ///< part of the surface to cut next, 0 to kParts − 1
  std::size_t next_ = 0;            ///< next entry of partialSlots_ to check
  std::size_t restoredGroups_ = 0;  ///< number of groups restored so far
  std::size_t clearedGroups_ = 0;   ///< number of groups that the device is known to be outside of
  bool isCutSinceReset_ = false;    ///< a sphere was cut since the bone was whole
  bool isOutside_ = false;          ///< see isOutside()
  double leastRemainderRadius_ = 0.0;  ///< remainders of a smaller radius are removed [m]
  double removedMass_ = 0.0;
  Reamer tool_;
};

}  // namespace haptics::reaming
