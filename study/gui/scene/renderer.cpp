#include "study/gui/scene/renderer.h"

#include <exception>

#include <QGuiApplication>

#include "study/gui/scene/gl_renderer.h"
#include "study/gui/scene/software_renderer.h"
#include "study/gui/widgets/desk_language.h"

namespace study::gui::scene {

namespace {

RendererWithRemark softwareRenderer(const QString& why) {
  return {
      std::make_unique<SoftwareRenderer>(),
      deskText(
          "The simulation is drawn by the processor: %1. It is complete, but coarser and slower. "
          "To have a graphics card draw it, sit at the computer itself instead of a remote "
          "desktop, and install the card's driver.")
          .arg(why)};
}

}  // namespace

RendererWithRemark makeRenderer(RendererChoice choice) {
  if (choice == RendererChoice::Software) {
    return softwareRenderer(deskText("that was asked for"));
  }
  const QString platform = QGuiApplication::platformName();
  if (platform == QLatin1String("offscreen") || platform == QLatin1String("minimal") ||
      platform == QLatin1String("vnc") || platform == QLatin1String("linuxfb")) {
    return softwareRenderer(deskText("this display has no OpenGL"));
  }
  try {
    const bool isFinest = choice == RendererChoice::FullDetail;
    RendererWithRemark graphics{
        std::make_unique<GlRenderer>(
            isFinest ? GlRenderer::Detail::FullDetail : GlRenderer::Detail::ByHardware),
        {}};
    if (graphics.renderer->isOnProcessor()) {
      graphics.remark =
          deskText(
              "The simulation is drawn without a graphics card (%1), at up to 30 pictures a "
              "second. For more, use a computer with a card and install its driver.")
              .arg(graphics.renderer->name());
    }
    return graphics;
  } catch (const std::exception& error) {
    return softwareRenderer(QString::fromUtf8(error.what()));
  }
}

}  // namespace study::gui::scene
