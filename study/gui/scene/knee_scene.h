#pragma once

#include "study/gui/scene/shapes/meniscus.h"
#include "study/gui/scene/simulated_scene.h"

namespace protocols {
struct Anatomy;
}

namespace study::gui::scene {

/// A knee as an arthroscope shows it, with a punch at the meniscus; beside it the whole punch, so
/// that its handles can be seen.
class KneeScene final : public SimulatedScene {
 public:
  /// @param own  surfaces in place of ours; nothing: ours. Not needed any more afterwards.
  explicit KneeScene(const protocols::Anatomy* own = nullptr);

  void follow(const Look& look, double seconds) override;
  const Scene& scene() const noexcept override { return scene_; }
  const Meniscus& meniscus() const noexcept { return meniscus_; }

 private:
  enum PartIndex : std::size_t {
    Plateau,
    Condyle,
    Capsule,
    Tissue,
    Piece,
    Body,
    Grip,
    Jaw,
    Rod,
    Lever
  };

  void add(Mesh mesh, const QMatrix4x4& pose = {});
  void lookThroughTheScope();
  void lookAtTheHandles();
  void followTheCut(const Look& look);
  void movePiece(double seconds);

  KneeLayout layout_;
  Scene scene_;
  Meniscus meniscus_;
  bool isParted_ = false;  ///< in this closure
  double released_ = 0.0;  ///< since the piece was let go [s]
  float toMoveOn_ = 0.0F;  ///< of the tissue, under the punch [°]
};

}  // namespace study::gui::scene
