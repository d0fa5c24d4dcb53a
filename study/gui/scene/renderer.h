#pragma once

#include <cstdint>
#include <memory>

#include <QImage>
#include <QString>

#include "study/gui/scene/scene.h"

namespace study::gui::scene {

/// Draws scenes. One scene all along: a renderer may keep copies of its bodies.
class Renderer {
 public:
  virtual ~Renderer() = default;
  Renderer() = default;
  Renderer(const Renderer&) = delete;
  Renderer& operator=(const Renderer&) = delete;

  /// A picture of @p size pixels, good until the next is drawn.
  virtual const QImage& draw(const Scene& scene, QSize size) = 0;

  /// Who draws: "llvmpipe (LLVM 15.0.6, 256 bits)", "software rasteriser".
  virtual QString name() const = 0;

  /// Whether a processor does the work that a graphics card is for.
  virtual bool isOnProcessor() const = 0;

  /// What has been handed on about spheres since the beginning.
  virtual std::uint64_t sphereBytes() const = 0;
};

/// Who draws on this computer, and what there is to say about it.
struct Graphics {
  std::unique_ptr<Renderer> renderer;
  /// For the person at the desk: why no graphics card draws, what follows, what to do. Empty where
  /// one does.
  QString remark;
};

/// Which renderer is asked for.
enum class RendererChoice {
  Best,      ///< OpenGL where there is any, the processor where there is none
  Software,  ///< the processor, whatever there is
  Finest,    ///< OpenGL with everything that a graphics card is trusted with, whoever draws
};

/// Never fails: the processor draws where nothing else does.
Graphics openGraphics(RendererChoice choice = RendererChoice::Best);

}  // namespace study::gui::scene
