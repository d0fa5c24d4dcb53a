#pragma once

#include <vector>

#include "haptics/engine/compiled_scene.h"
#include "study/gui/scene/shapes/knee_anatomy.h"
#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// The meniscus that is drawn: a wedge bent to a crescent, thin at its free edge. It gives way as
/// the finite-element mesh does, keeps clear of the jaws, and parts where it is cut: a bite is then
/// a piece of its own. Body and piece are closed surfaces, and hold together what was there before.
class Meniscus {
 public:
  explicit Meniscus(const KneeLayout& layout);

  /// What presses on it.
  struct Squeeze {
    /// The string of finite elements under the tool; the largest displacement is where the tool
    /// is. None: nothing presses.
    std::vector<haptics::engine::MeshView::Point> string;
    float openness = 1.0F;  ///< of the jaw
  };

  /// Shapes body and piece anew.
  void squeeze(const Squeeze& squeeze);

  /// Parts a bite from the free edge, where the punch is.
  void cut();
  /// The piece is taken away.
  void dropPiece() { hasPiece_ = false; }
  /// Moves the tissue along under the punch by @p angle [°], for the next bite.
  void moveOn(float angle) { moved_ += angle; }

  bool hasPiece() const noexcept { return hasPiece_; }
  const Mesh& body() const noexcept { return body_; }
  const Mesh& piece() const noexcept { return piece_; }

 private:
  /// A column of tissue: from below to above at one place.
  struct Column {
    QVector3D low;
    QVector3D high;
  };

  float edgeAt(float angle, std::size_t bites) const;
  Column column(float angle, float radius, const Squeeze& squeeze) const;
  void keepClearOfTheJaws(Column& column, float openness) const;
  float displacementAt(float angle, const Squeeze& squeeze) const;
  void shape(Mesh& mesh, float from, float to, bool isPiece, const Squeeze& squeeze) const;
  void addSection(Mesh& mesh, float angle, bool isPiece, const Squeeze& squeeze) const;

  KneeLayout layout_;
  QMatrix4x4 fromPunch_;
  QMatrix4x4 toPunch_;
  std::vector<float> bites_;  ///< where, on the tissue itself [°]
  float moved_ = 0.0F;        ///< of the tissue under the punch [°]
  bool hasPiece_ = false;
  Mesh body_;
  Mesh piece_;
};

}  // namespace study::gui::scene
