// The part of the self-test that checks screens.
#include <QGuiApplication>
#include <QScreen>

#include "study/gui/desk/self_test.h"
#include "study/gui/scene/renderer.h"
#include "study/gui/widgets/desk_language.h"

namespace study::gui {
namespace {

using haptics::devices::CheckResult;
using haptics::devices::Finding;

constexpr int kLeastWide = 1280;
constexpr int kLeastHigh = 800;
constexpr double kLeastRefresh = 50.0;  // [Hz]

SelfTestLine judgeScreen(const QScreen& screen) {
  const QSize size = screen.geometry().size();
  CheckResult found{
      .what = screen.name().isEmpty() ? "screen" : screen.name().toStdString(),
      .measured = said("{} × {} points", size.width(), size.height()),
      .fix = ""};
  if (size.width() < kLeastWide || size.height() < kLeastHigh) {
    found.finding = Finding::Warn;
    found.fix = "The windows want 1280 × 800 points: choose a higher resolution or less scaling.";
  } else if (screen.refreshRate() < kLeastRefresh) {
    found.finding = Finding::Warn;
    found.fix = "Pictures come late: choose a refresh rate of 50 Hz or more.";
  }
  return {
      "screen",
      found,
      said("scale {:g}, {:.0f} Hz", screen.devicePixelRatio(), screen.refreshRate())};
}

/// Tests which renderer is available by opening one.
SelfTestLine judgeGraphics() {
  const auto graphics = scene::openGraphics();
  const bool isFast = graphics.remark.isEmpty();
  return {
      "screen",
      {isFast ? Finding::Pass : Finding::Warn,
       "pictures of simulations",
       isFast ? "drawn by the graphics card" : "drawn by the processor",
       graphics.remark.toStdString()},
      said("drawn by {}", graphics.renderer->name().toStdString())};
}

}  // namespace

std::vector<SelfTestLine> testScreens() {
  std::vector<SelfTestLine> lines;
  const auto screens = QGuiApplication::screens();
  for (const auto* screen : screens) lines.push_back(judgeScreen(*screen));
  if (screens.size() < 2) {
    lines.push_back(
        {"screen",
         {Finding::Warn,
          "participant's screen",
          "there is one screen only",
          "Connect a second one: the participant's window goes there by itself."},
         ""});
  }
  lines.push_back(judgeGraphics());
  return lines;
}

}  // namespace study::gui
