#pragma once

#include <optional>
#include <vector>

#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLExtraFunctions>

#include "study/gui/scene/gl_program.h"
#include "study/gui/scene/renderer.h"

namespace study::gui::scene {

/// Draws scenes with OpenGL 3.3, beside the screen, and reads the picture back: the window stays an
/// ordinary one, and everything is alike whoever draws. What changes is handed on, and nothing
/// else: bodies whose shape is new, spheres that the reamer has touched.
class GlRenderer final : public Renderer {
 public:
  enum class Detail {
    Fitting,  ///< light at every pixel and smooth edges on a graphics card only
    Finest,   ///< everywhere, however long it takes
  };

  /// @throws std::runtime_error  in words, where there is no OpenGL 3.3.
  explicit GlRenderer(Detail detail = Detail::Fitting);
  ~GlRenderer() override;

  const QImage& draw(const Scene& scene, QSize size) override;
  QString name() const override { return name_; }
  bool isOnProcessor() const override { return isOnProcessor_; }
  std::uint64_t sphereBytes() const override { return sphereBytes_; }

 private:
  /// A body on the card.
  struct Body {
    GLuint array = 0;
    GLuint vertices = 0;
    GLuint triangles = 0;
    std::uint64_t revision = 0;
    std::size_t count = 0;  ///< of triangles
  };
  /// A picture in the making: what is drawn on, and where it is read from.
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
  void tellLight(GlProgram& program, const Shot& shot, QRect place);
  void readBack(QSize size);

  QOpenGLContext context_;
  QOffscreenSurface surface_;
  QOpenGLExtraFunctions gl_;
  QString name_;
  bool isOnProcessor_ = false;
  bool isFine_ = true;
  int samples_ = 0;  ///< of a pixel; 0: one
  std::optional<GlProgram> bodies_;
  std::optional<GlProgram> balls_;
  Canvas drawn_;
  Canvas read_;  ///< where samples are brought together
  std::vector<Body> parts_;
  GLuint ballArray_ = 0;
  GLuint ballBuffer_ = 0;
  std::size_t ballRoom_ = 0;  ///< instances
  std::uint64_t sphereBytes_ = 0;
  QImage picture_;
};

}  // namespace study::gui::scene
