#pragma once

#include "study/gui/scene/shapes/mesh.h"

namespace study::gui::scene {

/// The built-in acetabular reamer: a hollow dome of @p radius [mm] around the origin, with its
/// teeth towards +z, on a shaft along −z.
struct ReamerShape {
  Mesh cap;    ///< spins; the dome, its cross and each of its teeth are closed surfaces
  Mesh shaft;  ///< spins
};

ReamerShape reamerShape(float radius);

/// The reamer as a cage of wires, through which the bone behind it is seen. Closed surfaces.
Mesh reamerOutline(float radius);

}  // namespace study::gui::scene
