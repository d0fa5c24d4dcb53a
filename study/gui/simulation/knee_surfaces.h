#pragma once

#include "study/gui/simulation/knee_layout.h"
#include "study/gui/simulation/mesh.h"

namespace study::gui::simulation {

/// What surrounds the meniscus, as plain curved sheets: cartilage below and above, the joint's
/// capsule behind.
Mesh plateauSurface();
Mesh condyleSurface();
Mesh capsuleSurface(const KneeLayout& layout);

}  // namespace study::gui::simulation
