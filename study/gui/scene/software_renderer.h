#pragma once

#include <array>
#include <vector>

#include "study/gui/scene/renderer.h"
#include "study/gui/scene/scene.h"

namespace study::gui::scene {

/// The brightness of a surface, for the renderer without shaders. gl_shaders.h has the same
/// equations.
///
/// Light comes from one lamp and evenly from all directions. Surfaces reflect it diffusely
/// (Lambert) and, by their gloss, in a highlight (Blinn). Polished steel mirrors its surroundings
/// above and below. A view through an arthroscope darkens towards its rim.
struct Brightness {
  float diffuse = 0.0F;  ///< multiplies the colour of the surface
  float shine = 0.0F;    ///< brightness of the highlight that is added
};

/// @param place, normal  in the eye's frame. @param gloss  in [0, 1].
Brightness brightnessOf(const Light& light, QVector3D place, QVector3D normal, float gloss);

/// The share of light that is left in the shadow of a tool, 1 outside of it. @param shadow, place
/// in the same frame.
float lightAfterShadow(const ContactShadow& shadow, QVector3D place);

/// The darkening of a round view at @p radius from its middle; its rim is at radius 1.
struct Vignette {
  float brightness = 1.0F;    ///< share of the brightness, which falls towards the rim
  float visibleShare = 1.0F;  ///< share of the view; the rest is background
};
Vignette vignette(float radius);

/// Converts a colour channel from the screen's scale to linear light, 0 to 1.
inline float linear(std::uint8_t channel) {
  const float c = static_cast<float>(channel) / 255.0F;
  return c * c;
}

/// Draws scenes on the processor without OpenGL. Light is computed per vertex, with a depth buffer
/// per pixel. Edges of bodies are smoothed.
class SoftwareRenderer final : public Renderer {
 public:
  const QImage& draw(const Scene& scene, QSize size) override;
  QString name() const override { return QStringLiteral("software rasteriser"); }
  bool isOnProcessor() const override { return true; }
  std::uint64_t sphereBytes() const override { return sphereBytes_; }

 private:
  /// A vertex during projection.
  struct Corner {
    QVector3D eye;                                  ///< position in the eye's frame
    float x = 0.0F, y = 0.0F, inverseDepth = 0.0F;  ///< on the screen; 1 / distance
    float red = 0.0F, green = 0.0F, blue = 0.0F;
  };
  struct Frame {
    const Shot* shot = nullptr;
    QRect place;
    QMatrix4x4 projection;
    std::array<ContactShadow, 2> shadows;  ///< in the eye's frame
  };

  void begin(const Frame& frame);
  void drawPart(const Frame& frame, const Part& part);
  void light(
      const Frame& frame,
      const Vertex& vertex,
      QVector3D normal,
      bool isTool,
      Corner& corner) const;
  void project(const Frame& frame, Corner& corner) const;
  void clip(const Frame& frame, const Corner& a, const Corner& b, const Corner& c);
  void fill(const Frame& frame, const Corner& a, const Corner& b, const Corner& c);
  void fillRow(int y, int from, int to, const Corner& at, const Corner& perPixel);
  void drawSpheres(const Frame& frame, SphereCloud& spheres);
  void drawSphere(const Frame& frame, const SphereInstance& sphere, QVector3D toLamp);
  void darkenRim(const Frame& frame, QRgb ground);
  void smoothEdges(QRect place);

  QImage picture_;
  std::vector<float> nearness_;  ///< 1 / distance of each pixel; 0: empty
  std::vector<Corner> corners_;
  struct Pixel {
    int place = 0;  ///< in the picture, row by row
    QRgb colour = 0;
  };
  std::vector<Pixel> smoothed_;  ///< new colours of the pixels along outlines, see smoothEdges()
  std::uint64_t sphereBytes_ = 0;
};

}  // namespace study::gui::scene
