// What a self-test says of the screens.
#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QOpenGLFunctions>
#include <QScreen>

#include "study/gui/home/self_test.h"

namespace study::gui::home {
namespace {

using haptics::devices::CheckResult;
using haptics::devices::Finding;

constexpr int kLeastWide = 1280;
constexpr int kLeastHigh = 800;
constexpr double kLeastRefresh = 50.0;  // [Hz]

CheckResult judgeScreen(const QScreen& screen) {
  const QSize size = screen.geometry().size();
  CheckResult found{
      .what = screen.name().isEmpty() ? "screen" : screen.name().toStdString(),
      .measured = QStringLiteral("%1 × %2 points, scale %3, %4 Hz")
                      .arg(size.width())
                      .arg(size.height())
                      .arg(screen.devicePixelRatio())
                      .arg(screen.refreshRate(), 0, 'f', 0)
                      .toStdString(),
      .mend = ""};
  if (size.width() < kLeastWide || size.height() < kLeastHigh) {
    found.finding = Finding::Warn;
    found.mend = "The windows want 1280 × 800 points: choose a higher resolution or less scaling.";
  } else if (screen.refreshRate() < kLeastRefresh) {
    found.finding = Finding::Warn;
    found.mend = "Pictures come late: choose a refresh rate of 50 Hz or more.";
  }
  return found;
}

CheckResult judgeOpenGl() {
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!context.create() || !context.makeCurrent(&surface)) {
    return {
        Finding::Warn,
        "OpenGL",
        "none",
        "Pictures in three dimensions are left out; everything else works. Install the driver of "
        "the graphics card (on Debian: libgl1-mesa-dri)."};
  }
  const auto* name = context.functions()->glGetString(GL_RENDERER);
  const auto renderer = QString::fromUtf8(reinterpret_cast<const char*>(name));
  context.doneCurrent();
  const bool isSoftware = renderer.contains(QStringLiteral("llvmpipe"), Qt::CaseInsensitive) ||
                          renderer.contains(QStringLiteral("softpipe"), Qt::CaseInsensitive);
  return {
      isSoftware ? Finding::Warn : Finding::Pass,
      "OpenGL",
      renderer.toStdString(),
      isSoftware ? "The processor draws, which the force loop needs: install the driver of the "
                   "graphics card."
                 : ""};
}

}  // namespace

std::vector<SelfTestLine> testScreens() {
  std::vector<SelfTestLine> lines;
  const auto screens = QGuiApplication::screens();
  for (const auto* screen : screens) lines.push_back({"screen", judgeScreen(*screen)});
  if (screens.size() < 2) {
    lines.push_back(
        {"screen",
         {Finding::Warn,
          "participant's screen",
          "there is one screen only",
          "Connect a second one: the participant's window goes there by itself."}});
  }
  lines.push_back({"screen", judgeOpenGl()});
  return lines;
}

}  // namespace study::gui::home
