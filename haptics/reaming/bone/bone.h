#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "haptics/reaming/bone/sphere_field.h"

namespace haptics::reaming {

/// How a bone that is cut answers.
struct BoneOptions {
  double coverage = 1.0;       ///< of the packing: areas are divided by it, (0, 1]
  double coupling = 50'000.0;  ///< between the device and the tool that the bone holds [N/m], > 0
  double cuttingDamping = 2000.0;  ///< increase of the force with the feed [N·s/m], >= 0
  double friction = 0.1;           ///< coefficient between tool and bone, >= 0
  double mostAdvance = 5e-5;       ///< in one step, through bone [m], > 0
  /// What the teeth can take: no faster through bone, however hard it is pushed [m/s], >= 0.
  double mostFeed = std::numeric_limits<double>::infinity();
  bool isGuided = false;   ///< held to a line along its axis, as by a testing machine
  bool isSpinning = true;  ///< forwards; teeth that stand still or go backwards do not cut
};

/// A bone of spheres that a reamer removes.
///
/// The tool is held by the bone (a constrained tool, as in the reaming paper): it goes on only
/// while the coupling to the device pushes harder than what it touches gives way at, F = Σ aρ /
/// coverage, no faster than its teeth can take, and takes the spheres behind its surface away, each
/// within eight steps. A sphere is
/// cut slice by slice; when the tool has left it, what remains is shrunk, displaced and split into
/// spheres that lie within it, with the mass (density × volume) that remained. All removed mass is
/// counted.
///
/// A step is bounded, allocates nothing and throws nothing.
class Bone {
 public:
  /// @throws std::invalid_argument  if packing, densities or options are not valid.
  Bone(const Packing& packing, std::span<const double> densities, const BoneOptions& options);

  struct Felt {
    Vec3 force;              ///< on the hand [N]
    double rubbing = 0.0;    ///< torque on a reamer that turns either way, against its spin [N·m]
    ReamerContact contact;   ///< of the held tool
    bool isDefined = false;  ///< not where the device is nowhere, or began inside of the bone
  };

  /// One step of @p dt [s] with the device at @p device.
  Felt step(const Reamer& device, double dt) noexcept;

  /// Whether the teeth cut from the next step on; as in the options at first.
  void setSpinning(bool isSpinning) noexcept { isSpinning_ = isSpinning; }

  /// Makes the bone whole again, over the next steps; until then nothing is felt.
  void reset() noexcept;

  const Reamer& tool() const noexcept { return tool_; }  ///< where the bone holds it
  const SphereField& field() const noexcept { return field_; }
  double coverage() const noexcept { return options_.coverage; }

  double removedMass() const noexcept { return removed_; }  ///< [N·m]
  double remainingMass() const noexcept;                    ///< by looking at all spheres [N·m]

  /// Slots that the last step emptied, shrank, moved or filled, for the eye.
  std::span<const std::uint32_t> changed() const noexcept { return changed_; }
  /// Changes that found no room in the list.
  std::uint64_t droppedChanges() const noexcept { return dropped_; }
  /// Whether all spheres have been seen to be clear of the device since it began or was reset.
  /// Until then some are looked at in every step.
  bool isOutside() const noexcept { return isOutside_; }
  /// How often it has been made whole again.
  std::uint64_t restorations() const noexcept { return restorations_; }

 private:
  bool isWholeAgain() noexcept;
  bool isClear() noexcept;
  Vec3 outOf(const ReamerContact& contact) const noexcept;
  void moveTool(const Reamer& device, const ReamerContact& contact, Vec3 out, double dt) noexcept;
  Vec3 slideOf(Vec3 gap, Vec3 out, double push) const noexcept;
  void cut() noexcept;
  void cutSlot(std::uint32_t slot) noexcept;
  void compactChanges() noexcept;
  bool isLeft(std::uint32_t slot) const noexcept;
  void leaveRemainder(std::uint32_t slot) noexcept;
  double massOf(std::uint32_t slot) const noexcept;
  void empty(std::uint32_t slot) noexcept;
  void noteChange(std::uint32_t slot) noexcept;

  BoneOptions options_;
  bool isSpinning_;
  SphereField field_;
  SphereField whole_;
  std::vector<Vec3> cutFrom_;           ///< where the tool was when it last cut a slot
  std::vector<std::uint32_t> partial_;  ///< slots that are partly cut
  std::vector<char> isPartial_;
  std::vector<std::uint32_t> deeper_;  ///< room for what a step cuts
  std::vector<std::uint32_t> changed_;
  std::uint64_t dropped_ = 0;
  std::uint64_t restorations_ = 0;
  std::size_t pending_ = 0;   ///< steps until all that lies behind the surface is cut
  std::size_t part_ = 0;      ///< whose turn it is
  std::size_t next_ = 0;      ///< of partial_, to be looked at
  std::size_t restored_ = 0;  ///< groups of the whole bone, while it is made whole
  std::size_t cleared_ = 0;   ///< groups that the device is known to be outside of
  bool isTouched_ = false;    ///< something was cut since it was whole
  bool isOutside_ = false;    ///< the device has been outside since
  double smallest_ = 0.0;     ///< radius that is worth a sphere [m]
  double removed_ = 0.0;
  Reamer tool_;
};

}  // namespace haptics::reaming
