#pragma once

#include <algorithm>
#include <atomic>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "base/random.h"
#include "haptics/engine/bucket_table.h"
#include "haptics/engine/force_model.h"
#include "haptics/engine/sample_ring.h"
#include "haptics/engine/scene_spec.h"
#include "haptics/models/hermite_curve.h"
#include "haptics/reaming/bone/bone.h"
#include "haptics/reaming/bone/packing.h"
#include "haptics/reaming/bone/sphere_field.h"
#include "haptics/reaming/material/material.h"
#include "haptics/reaming/packing/packed_bone.h"

namespace haptics::engine {

/// A change of one sphere, for drawing the bone. A radius of 0 means that the sphere was removed.
struct SphereChange {
  /// Value of slot that means: the bone was reset, all spheres have their initial radius again.
  static constexpr std::uint32_t kWholeBoneReset = 0xffffffffU;

  std::uint32_t slot = 0;
  reaming::Sphere sphere;
};

/// Passes the changes of a bone while it is reamed, and the depth of the reamer, to the thread that
/// draws. The tick is the only writer; the one reader keeps its own copy of all spheres.
class BoneView {
 public:
  /// For the reader: the next change; false if there is none.
  bool next(SphereChange& change) noexcept { return changes_.pop(change); }

  /// Depth of the reamer along its path [m].
  double depth() const noexcept { return depth_.load(std::memory_order_relaxed); }

  /// Number of changes that were lost because a buffer was full. The picture still shows the
  /// spheres whose removal was lost.
  std::uint64_t lost() const noexcept {
    return changes_.lost() + unreported_.load(std::memory_order_relaxed);
  }

  /// The functions below are for the writer.
  void add(const SphereChange& change) noexcept { changes_.push(change); }
  void setDepth(double depth) noexcept { depth_.store(depth, std::memory_order_relaxed); }
  void setUnreported(std::uint64_t changes) noexcept {
    unreported_.store(changes, std::memory_order_relaxed);
  }

 private:
  SampleRing<SphereChange, 1U << 15U> changes_;
  std::atomic<double> depth_{0.0};
  std::atomic<std::uint64_t> unreported_{0};
};

/// Noise over time that imitates the jitter of a measured force: one normally distributed number
/// per sample of the measurement, linearly interpolated in between. The noise changes even while
/// the tool rests, and for small forces it is proportional to the force. So no slope bounds it, see
/// RenderedSlope::jitter.
class JitterNoise {
 public:
  /// @param scale  scale factor of all forces of the scene.
  JitterNoise(const reaming::Jitter& jitter, double scale, std::uint64_t seed) noexcept
      : rms_(scale * jitter.rms), rate_(jitter.rate), seed_(seed), random_(seed) {
    reset();
  }

  /// Advances by @p dt [s] and returns the noise to add to @p force [N]. For small forces the noise
  /// is reduced in proportion to the force; it never reverses the force's sign.
  double step(double force, double dt) noexcept {
    if (!(rms_ > 0.0)) return 0.0;
    phase_ += std::min(rate_ * dt, 1.0);
    if (phase_ >= 1.0) {
      phase_ -= 1.0;
      last_ = next_;
      next_ = random_.normal();
    }
    const double share = std::clamp(force / (kFullNoiseRatio * rms_), 0.0, 1.0);
    const double noise = share * rms_ * (last_ + phase_ * (next_ - last_));
    return std::max(noise, -std::max(force, 0.0));
  }

  void reset() noexcept {
    random_ = base::SplitMix64(seed_);
    phase_ = 0.0;
    last_ = 0.0;
    next_ = rms_ > 0.0 ? random_.normal() : 0.0;
  }

 private:
  /// If the force is at least kFullNoiseRatio · RMS, the noise is not reduced.
  static constexpr double kFullNoiseRatio = 5.0;

  double rms_;   ///< [N]
  double rate_;  ///< [Hz]
  std::uint64_t seed_;
  base::SplitMix64 random_;
  /// Time since the last sample, as a fraction of the sampling interval, 0 to 1.
  double phase_ = 0.0;
  double last_ = 0.0;
  double next_ = 0.0;
};

/// A cubic Hermite spline that owns its segments and their search index: the tick evaluates a
/// single cubic.
class BlendedCurve {
 public:
  using Segments = std::vector<models::CubicSegment<double>>;

  /// @param segments  valid.
  explicit BlendedCurve(Segments segments);
  BlendedCurve(const BlendedCurve&) = delete;
  BlendedCurve& operator=(const BlendedCurve&) = delete;

  models::Response<double> at(double depth) noexcept { return curve_.at(depth, hint_); }
  void reset() noexcept { hint_ = 0; }
  const Segments& segments() const noexcept { return segments_; }
  std::size_t bytes() const noexcept { return segments_.size() * sizeof(segments_[0]); }

 private:
  Segments segments_;
  BucketTable table_;
  models::HermiteCurve<double> curve_;
  std::size_t hint_ = 0;
};

/// Force and torque of bone over depth, from curves that the constructor blends for one hardness.
class MaterialModel final : public ForceModel {
 public:
  /// @param spec  and @p reamer: valid, see problemsOf().
  explicit MaterialModel(const MaterialSpec& spec, const Reamer& reamer = {});

  models::Response<double> respond(const ToolState& tool) noexcept override {
    auto response = force_.at(tool.travel);
    if (response.isDefined) response.force += jitter_.step(response.force, tool.dt);
    updateTorque(tool);
    return response;
  }
  void reset() noexcept override {
    force_.reset();
    if (torqueCurve_) torqueCurve_->reset();
    torque_ = 0.0;
    jitter_.reset();
  }
  double largestStiffness() const noexcept override;
  /// std::nullopt if the curve begins with a jump.
  std::optional<SlopeBound> slopeBound() const noexcept override;
  double torque() const noexcept override { return torque_; }
  bool hasTorque() const noexcept override { return torqueCurve_.has_value(); }

  const std::vector<models::CubicSegment<double>>& segments() const noexcept {
    return force_.segments();
  }
  std::size_t bytes() const noexcept { return force_.bytes(); }

 private:
  void updateTorque(const ToolState& tool) noexcept;

  BlendedCurve force_;
  std::optional<BlendedCurve> torqueCurve_;  ///< std::nullopt if no torque is rendered
  int sign_;
  double torque_ = 0.0;  ///< [N·m]
  JitterNoise jitter_;
};

/// The force curve of @p spec at its hardness, times its force scale. The nodes must have
/// increasing depth.
std::vector<models::CubicSegment<double>> blendedSegments(const MaterialSpec& spec);

/// The torque curve of @p spec at its hardness, times its force scale [N·m]; empty if the material
/// has no torque.
std::vector<models::CubicSegment<double>> blendedTorque(const MaterialSpec& spec);

/// Force of a bone of spheres that is not removed: a function of the reamer's depth.
class PackingModel final : public ForceModel {
 public:
  /// @param spec  and @p reamer: valid, see problemsOf().
  explicit PackingModel(const PackingSpec& spec, const Reamer& reamer = {});

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override {}
  double largestStiffness() const noexcept override { return largestStiffness_; }
  std::optional<SlopeBound> slopeBound() const noexcept override {
    return SlopeBound{.slope = largestStiffness_, .isSampled = true};
  }
  double torque() const noexcept override { return torque_; }
  bool hasTorque() const noexcept override { return friction_ != 0.0; }
  std::size_t bytes() const noexcept { return field_.bytes(); }

 private:
  double forceOf(const reaming::ReamerContact& contact) const noexcept {
    return -contact.force.z / coverage_;
  }

  reaming::SphereField field_;
  reaming::PlungePath plunge_;
  double coverage_;
  double friction_;  ///< coefficient of friction, with the sign of the torque
  double torque_ = 0.0;
  double largestStiffness_ = 0.0;
};

/// Force of a bone of spheres that the reamer removes.
class RemovalModel final : public ForceModel {
 public:
  /// @param spec  valid, see problemsOf().
  /// @param isVisualised  whether the bone is drawn; otherwise view() is nullptr.
  /// @param reamer  valid, see problemsOf().
  explicit RemovalModel(
      const PackingSpec& spec, bool isVisualised = false, const Reamer& reamer = {});

  models::Response<double> respond(const ToolState& tool) noexcept override;
  void reset() noexcept override {
    torque_ = 0.0;
    bone_.reset();
  }
  bool isReady() const noexcept override { return bone_.isOutside(); }
  double largestStiffness() const noexcept override { return stiffness_; }
  double torque() const noexcept override { return torque_; }
  bool hasTorque() const noexcept override { return torqueSign_ != 0; }
  std::size_t bytes() const noexcept { return bone_.field().bytes(); }

  const reaming::Bone& bone() const noexcept { return bone_; }
  /// nullptr if the bone is not drawn.
  BoneView* view() const noexcept { return view_.get(); }

 private:
  void updateView() noexcept;

  reaming::Bone bone_;
  reaming::PlungePath plunge_;
  double stiffness_;
  bool isTurningForwards_;  ///< the reamer turns in the direction in which its teeth cut
  int torqueSign_;
  double torque_ = 0.0;  ///< [N·m]
  std::unique_ptr<BoneView> view_;
  std::uint64_t restorations_ = 0;  ///< number of the bone's resets that were passed to the view
};

}  // namespace haptics::engine
