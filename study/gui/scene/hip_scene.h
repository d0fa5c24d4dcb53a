#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <utility>

#include "haptics/reaming/packing/packed_bone.h"
#include "study/gui/scene/simulated_scene.h"

namespace study::gui::scene {

/// A cup that is reamed, cut open along its axis so that one sees the reamer at work: the spheres
/// of the condition's bone, or a plain cup where there are none.
class HipScene final : public SimulatedScene {
 public:
  struct Options {
    const haptics::engine::PackingSpec* packing = nullptr;  ///< of the condition; none: a plain cup
    SphereColours colours = SphereColours::Neutral;
  };

  explicit HipScene(const Options& options);

  void follow(const Look& look, double seconds) override;
  const Scene& scene() const noexcept override { return scene_; }

  /// Takes over what has happened to a sphere, from elsewhere than a trial's bone.
  void apply(const haptics::engine::SphereChange& change);
  /// Lets somebody else see every change as well, when it is followed; nobody: nothing.
  using Listener = std::function<void(const haptics::engine::SphereChange&)>;
  void tellChangesTo(Listener listener) { listener_ = std::move(listener); }
  /// Where the reamer is, along its plunge [m].
  double depth() const noexcept { return depth_; }
  const SphereCloud* spheres() const noexcept { return spheres_.get(); }

 private:
  enum PartIndex : std::size_t { Cap, Shaft, Cup };

  void addSpheres(const Options& options);
  void addPlainCup();
  void lookIntoTheCup();

  Scene scene_;
  std::unique_ptr<SphereCloud> spheres_;
  Listener listener_;
  double depth_ = 0.0;  ///< of the reamer [m]
  float start_ = 0.0F;  ///< z of the reamer's centre at a depth of 0 [mm]
  float spin_ = 0.0F;   ///< [°]
};

}  // namespace study::gui::scene
