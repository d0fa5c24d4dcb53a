#pragma once

#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// An acetabular reamer of our own making: half a sphere of @p radius [mm] around the origin with
/// its teeth towards +z, on a shaft along −z.
struct ReamerShape {
  Mesh cap;    ///< spins; closed but for its teeth, which are closed each
  Mesh shaft;  ///< spins
};

ReamerShape reamerShape(float radius);

}  // namespace study::gui::scene
