#pragma once

#include <vector>

#include "study/gui/scene/renderer.h"

namespace study::gui::scene {

/// Draws scenes on the processor alone, where there is no OpenGL: light is computed at vertices,
/// every pixel remembers how near it is.
class SoftwareRenderer final : public Renderer {
 public:
  const QImage& draw(const Scene& scene, QSize size) override;
  QString name() const override { return QStringLiteral("software rasteriser"); }
  bool isOnProcessor() const override { return true; }
  std::uint64_t sphereBytes() const override { return sphereBytes_; }

 private:
  /// A vertex on its way to the screen.
  struct Corner {
    QVector3D eye;                              ///< place in the eye's frame
    float x = 0.0F, y = 0.0F, nearness = 0.0F;  ///< on the screen; 1 / distance
    float red = 0.0F, green = 0.0F, blue = 0.0F;
  };
  struct Frame {
    const Shot* shot = nullptr;
    QRect place;
    QMatrix4x4 projection;
  };

  void begin(const Frame& frame);
  void drawPart(const Frame& frame, const Part& part);
  void light(const Frame& frame, const Vertex& vertex, QVector3D normal, Corner& corner) const;
  void project(const Frame& frame, Corner& corner) const;
  void clip(const Frame& frame, const Corner& a, const Corner& b, const Corner& c);
  void fill(const Frame& frame, const Corner& a, const Corner& b, const Corner& c);
  void fillRow(int y, int from, int to, const Corner& at, const Corner& perPixel);
  void drawSpheres(const Frame& frame, SphereCloud& spheres);
  void drawSphere(const Frame& frame, const SphereInstance& sphere, QVector3D toLamp);
  void darkenRim(const Frame& frame);

  QImage picture_;
  std::vector<float> nearness_;  ///< of every pixel: 1 / distance; 0: nothing there
  std::vector<Corner> corners_;
  std::uint64_t sphereBytes_ = 0;
};

}  // namespace study::gui::scene
