#pragma once

#include <memory>
#include <optional>

#include "haptics/reaming/packed_bone.h"
#include "study/gui/simulation/simulated_scene.h"

namespace study::gui::simulation {

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
  const SphereCloud* spheres() const noexcept { return spheres_.get(); }

 private:
  enum PartIndex : std::size_t { Cap, Shaft, Cup };

  void addSpheres(const Options& options);
  void addPlainCup();
  void lookIntoTheCup();

  Scene scene_;
  std::unique_ptr<SphereCloud> spheres_;
  float start_ = 0.0F;  ///< z of the reamer's centre at a depth of 0 [mm]
  float spin_ = 0.0F;   ///< [°]
};

}  // namespace study::gui::simulation
