#pragma once

#include <memory>

#include <QString>

#include "study/gui/scene/renderer.h"

namespace study::gui::scene {

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
