#pragma once

#include <vector>

#include "haptics/engine/compiled_scene.h"
#include "study/gui/scene/shapes/knee_anatomy.h"
#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// The visible meniscus: a wedge bent into a crescent, thin at its free edge. It deforms like the
/// finite-element mesh and does not intersect the jaws. A cut separates a bite, which becomes a
/// second closed surface. Body and piece together have the volume of the tissue before the cut.
class Meniscus {
 public:
  explicit Meniscus(const KneeLayout& layout);

  /// The load on the tissue.
  struct TissueLoad {
    /// The string of finite elements under the tool. Its largest displacement is at the
    /// tool. Empty: no load.
    std::vector<haptics::engine::MeshView::Point> string;
    float openness = 1.0F;  ///< of the jaw
  };

  /// Recomputes the shape of body and piece.
  void squeeze(const TissueLoad& squeeze);

  /// Cuts a bite out of the free edge at the position of the punch.
  void cut();
  /// Removes the piece.
  void removePiece() { hasPiece_ = false; }
  /// Moves the tissue under the punch by @p angle [°], to the position of the next bite.
  void moveOn(float angle) { moved_ += angle; }

  bool hasPiece() const noexcept { return hasPiece_; }
  const Mesh& body() const noexcept { return body_; }
  const Mesh& piece() const noexcept { return piece_; }

 private:
  /// A vertical column of tissue, from its lower to its upper point.
  struct Column {
    QVector3D low;
    QVector3D high;
  };

  float edgeAt(float angle, std::size_t bites) const;
  /// @param fullness  factor of the height of the undeformed tissue.
  Column column(float angle, float radius, float fullness, const TissueLoad& squeeze) const;
  void keepClearOfTheJaws(Column& column, float openness) const;
  float displacementAt(float angle, const TissueLoad& squeeze) const;
  void shape(Mesh& mesh, float from, float to, bool isPiece, const TissueLoad& squeeze) const;
  void glisten(Mesh& mesh) const;
  void addSection(Mesh& mesh, float angle, bool isPiece, const TissueLoad& squeeze) const;

  KneeLayout layout_;
  QMatrix4x4 fromPunch_;
  QMatrix4x4 toPunch_;
  std::vector<float> bites_;  ///< positions in the tissue's own frame [°]
  float moved_ = 0.0F;        ///< rotation of the tissue under the punch [°]
  bool hasPiece_ = false;
  Mesh body_;
  Mesh piece_;
};

}  // namespace study::gui::scene
