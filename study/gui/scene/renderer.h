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

}  // namespace study::gui::scene
