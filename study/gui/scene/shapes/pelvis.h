#pragma once

#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// The visible part of the pelvis around a cup of radius @p inner [mm] that is cut open at y = 0
/// and
/// opens towards −z: its section, with the roots of the ilium (−x) and the ischium (+x), and its
/// rim with the notch. Other surfaces would only cost time.
Mesh pelvisAround(float inner);

/// Half of a hollow hemisphere of bone [mm]: a section at y = 0, and its opening at z = 0.
Mesh halfShell(float inner, float outer);

}  // namespace study::gui::scene
