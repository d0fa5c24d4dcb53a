#pragma once

#include <optional>
#include <vector>

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

#include "study/gui/scene/gl_program.h"
#include "study/gui/scene/renderer.h"

namespace study::gui::scene {

/// Draws scenes with OpenGL 3.3 into an off-screen buffer and reads the picture back. The window
/// therefore needs no OpenGL, and pictures are handled alike for both renderers. Only changes are
/// uploaded: meshes with a new revision, and spheres that the reamer has touched.
class GlRenderer final : public Renderer {
 public:
  enum class Detail {
    ByHardware,  ///< per-pixel lighting and anti-aliasing only on a graphics card
    FullDetail,  ///< per-pixel lighting and anti-aliasing always, however slow
  };

  /// @throws std::runtime_error  with a message if OpenGL 3.3 is not available.
  explicit GlRenderer(Detail detail = Detail::ByHardware);
  ~GlRenderer() override;

  const QImage& draw(const Scene& scene, QSize size) override;
  QString name() const override { return name_; }
  bool isOnProcessor() const override { return isOnProcessor_; }
  std::uint64_t sphereBytes() const override { return sphereBytes_; }

 private:
  /// The buffers of a mesh on the graphics card.
  struct Body {
    GLuint array = 0;
    GLuint vertices = 0;
    GLuint triangles = 0;
    std::uint64_t revision = 0;
    std::size_t count = 0;  ///< number of triangles
  };
  /// A framebuffer with its colour and depth buffers.
  struct Canvas {
    GLuint frame = 0;
    GLuint colours = 0;
    GLuint depths = 0;
  };

  void makePrograms();
  void makeCanvas(Canvas& canvas, QSize size, int samples);
  void freeCanvas(Canvas& canvas);
  void upload(Body& body, const Part& part);
  void uploadSpheres(SphereCloud& spheres);
  void drawShot(const Scene& scene, const Shot& shot, QSize size);
  void setLight(GlProgram& program, const Shot& shot, QRect place);
  using Shadows = std::array<ContactShadow, 2>;
  static void setShadows(GlProgram& program, const Shadows& shadows);
  static void setDepths(GlProgram& program, const Shadows& shadows, bool areCast);
  void readBack(QSize size);

  QOpenGLContext context_;
  QOffscreenSurface surface_;
  QOpenGLExtraFunctions gl_;
  QString name_;
  bool isOnProcessor_ = false;
  bool isFullDetail_ = true;
  int samples_ = 0;  ///< per pixel; 0: no multisampling
  std::optional<GlProgram> bodyProgram_;
  std::optional<GlProgram> sphereProgram_;
  Canvas drawCanvas_;
  Canvas readCanvas_;  ///< the target in which samples are resolved
  std::vector<Body> parts_;
  GLuint sphereArray_ = 0;
  GLuint sphereBuffer_ = 0;
  std::size_t sphereCapacity_ = 0;  ///< capacity of the buffer [instances]
  std::uint64_t sphereBytes_ = 0;
  QImage picture_;
};

}  // namespace study::gui::scene
