#pragma once

#include <cstdint>
#include <memory>

#include <QImage>
#include <QString>

#include "study/gui/scene/scene.h"

namespace study::gui::scene {

/// Draws scenes. Use one renderer for one scene only, because it may cache the scene's meshes.
class Renderer {
 public:
  virtual ~Renderer() = default;
  Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// Draws a picture of @p size pixels, which is valid until the next call.
  virtual const QImage& draw(const Scene& scene, QSize size) = 0;

  /// The name of the renderer: "llvmpipe (LLVM 15.0.6, 256 bits)", "software rasteriser".
  virtual QString name() const = 0;

  /// Whether the processor draws instead of a graphics card.
  virtual bool isOnProcessor() const = 0;

  /// The number of bytes uploaded for spheres since the beginning.
  virtual std::uint64_t sphereBytes() const = 0;
};

/// The renderer for this computer, with a remark about it.
struct RendererWithRemark {
  std::unique_ptr<Renderer> renderer;
  /// A message for the operator: why no graphics card draws, the consequence, and what to do. Empty
  /// if a graphics card draws.
  QString remark;
};

/// The renderer to use.
enum class RendererChoice {
  Best,        ///< OpenGL if available, otherwise the software renderer
  Software,    ///< the software renderer
  FullDetail,  ///< OpenGL with all features, even without a graphics card
};

/// Makes a renderer. Never fails: without OpenGL it is the software renderer.
RendererWithRemark makeRenderer(RendererChoice choice = RendererChoice::Best);

}  // namespace study::gui::scene
