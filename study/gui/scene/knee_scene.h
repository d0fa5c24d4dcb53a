#pragma once

#include "study/gui/scene/shapes/meniscus.h"
#include "study/gui/scene/simulated_scene.h"

namespace protocols {
struct Anatomy;
}

namespace study::gui::scene {

/// A knee as an arthroscope shows it, with a punch at the meniscus. A second view beside it shows
/// the handles of the punch.
class KneeScene final : public SimulatedScene {
 public:
  /// @param own  surfaces that replace the built-in ones; nullptr: none. Not used after
  /// construction.
  explicit KneeScene(const protocols::Anatomy* own = nullptr);

  void update(const TrialSnapshot& snapshot, double seconds) override;
  const Scene& scene() const noexcept override { return scene_; }
  const Meniscus& meniscus() const noexcept { return meniscus_; }

  /// The whole instrument from its side with its tip to the left, and its handle alone.
  Shot wholeInstrument() const;
  Shot handleOfInstrument() const;

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
    Lever,
    RimMark
  };

  void add(Mesh mesh, const QMatrix4x4& pose = {});
  void setUpCamera();
  Shot sideOf(const std::vector<std::size_t>& parts) const;
  void updateCut(const TrialSnapshot& snapshot);
  void movePiece(double seconds);

  KneeLayout layout_;
  Scene scene_;
  Meniscus meniscus_;
  bool isCut_ = false;             ///< since the hand last opened
  double timeSinceRelease_ = 0.0;  ///< since the piece was released [s]
  float remainingShift_ = 0.0F;    ///< angle by which the tissue still moves under the punch [°]
};

}  // namespace study::gui::scene
