#pragma once

#include "study/gui/scene/shapes/knee_layout.h"
#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// How cartilage and a joint's capsule look where they are not painted more finely.
inline constexpr Tint kCartilage{238, 231, 216, 205};
inline constexpr Tint kSynovium{170, 78, 70, 130};

/// What surrounds the meniscus, as plain curved sheets: cartilage below and above, the joint's
/// capsule behind.
Mesh plateauSurface(const KneeLayout& layout);
Mesh condyleSurface();
Mesh capsuleSurface(const KneeLayout& layout);

}  // namespace study::gui::scene
