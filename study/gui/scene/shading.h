#pragma once

#include "study/gui/scene/scene.h"

namespace study::gui::scene {

/// How bright things are, for the renderer that has no shaders; gl_shaders.h says the same.
///
/// Light comes from one lamp and a little from everywhere, is thrown back evenly, and by gloss in a
/// highlight (Blinn); polished steel mirrors what is above and below. Seen through an arthroscope,
/// the picture grows darker towards its rim.
struct Brightness {
  float diffuse = 0.0F;  ///< times the colour of the surface
  float shine = 0.0F;    ///< added to it
};

/// @param place, normal  in the eye's frame. @param gloss  in [0, 1].
Brightness brightnessOf(const Light& light, QVector3D place, QVector3D normal, float gloss);

/// What is left at @p radius from the middle of a round look, 1 being its rim.
float vignette(float radius);

/// A colour in linear light, and back on the screen: 0 to 1.
inline float linear(std::uint8_t channel) {
  const float c = static_cast<float>(channel) / 255.0F;
  return c * c;
}

}  // namespace study::gui::scene
