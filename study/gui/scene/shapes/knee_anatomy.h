#pragma once

#include <optional>
#include <string>

#include "protocols/reading/anatomy_file.h"
#include "study/gui/scene/shapes/knee_layout.h"
#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// What surrounds the meniscus.
struct KneeSurfaces {
  Mesh tibia;
  Mesh femur;
  Mesh capsule;
};

/// Surfaces of our own making, and in their place those that @p own has, if there is one. A surface
/// without colours is painted as ours is.
KneeSurfaces kneeSurfaces(const KneeLayout& layout, const protocols::Anatomy* own);

/// Our own knee as an OBJ file's text, in the frame and the unit that protocols::Anatomy has: what
/// anatomies can be fitted to. Meniscus and punch are in it for orientation.
std::string kneeAsObj(const KneeLayout& layout);

}  // namespace study::gui::scene
