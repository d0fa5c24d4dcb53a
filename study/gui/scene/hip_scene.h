#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "haptics/reaming/packing/packed_bone.h"
#include "study/gui/scene/simulated_scene.h"

namespace study::gui::scene {

/// The acetabulum while it is reamed, cut open along its axis so that the reamer is visible. It
/// consists of the spheres of the condition's bone, or is a smooth surface if the condition has
/// none.
class HipScene final : public SimulatedScene {
 public:
  struct Options {
    const haptics::engine::PackingSpec* packing =
        nullptr;  ///< of the condition; nullptr: a smooth surface
    SphereColours colours = SphereColours::Neutral;
  };

  explicit HipScene(const Options& options);

  void update(const TrialSnapshot& snapshot, double seconds) override;
  const Scene& scene() const noexcept override { return scene_; }

  /// Applies a change of a sphere that does not come from a trial's bone.
  void apply(const haptics::engine::SphereChange& change);
  using Listener = std::function<void(const haptics::engine::SphereChange&)>;
  /// From now on update() also passes each change of a sphere to @p listener; empty: to none.
  void setListener(Listener listener) { listener_ = std::move(listener); }
  /// The depth of the reamer along its path [m].
  double depth() const noexcept { return depth_; }
  const SphereCloud* spheres() const noexcept { return spheres_.get(); }

 private:
  enum PartIndex : std::size_t { Cap, Shaft, Pelvis, Acetabulum };

  void addReamer(float radius, bool isOutline);
  void addSpheres(const Options& options);
  void addUncutBone();
  void addPelvis(float radius);
  void setUpCamera();

  Scene scene_;
  std::unique_ptr<SphereCloud> spheres_;
  Listener listener_;
  double depth_ = 0.0;      ///< of the reamer [m]
  float startZ_ = 0.0F;     ///< z of the reamer's centre at a depth of 0 [mm]
  float spinAngle_ = 0.0F;  ///< [°]
};

}  // namespace study::gui::scene
