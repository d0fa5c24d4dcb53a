#include "study/gui/session/tool_picture.h"

#include <algorithm>

#include <QPainter>
#include <QTimer>

#include "study/gui/scene/knee_scene.h"
#include "study/gui/scene/renderer.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

constexpr QSize kUsual(560, 300);   // [px] at scale 1
constexpr int kRendererDelay = 20;  // [ms]

/// The view of a scene that shows the whole instrument, alone on @p ground.
scene::Scene instrumentOn(const QColor& ground) {
  scene::KneeScene knee;
  auto alone = knee.scene();
  auto shot = alone.shots.back();
  shot.place = {0.0, 0.0, 1.0, 1.0};
  shot.ground = {
      static_cast<std::uint8_t>(ground.red()),
      static_cast<std::uint8_t>(ground.green()),
      static_cast<std::uint8_t>(ground.blue()),
      0};
  alone.shots = {shot};
  return alone;
}

}  // namespace

ToolPicture::ToolPicture(QWidget* parent) : QWidget(parent) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

bool ToolPicture::isKnown(const haptics::devices::DeviceKind& device) noexcept {
  return device.view == haptics::devices::View::Knee;
}

QSize ToolPicture::sizeHint() const {
  return {scaled(*this, kUsual.width()), scaled(*this, kUsual.height())};
}

void ToolPicture::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  picture_ = {};
  QTimer::singleShot(kRendererDelay, this, [this] { draw(); });
}

void ToolPicture::draw() {
  if (!picture_.isNull() || width() < 1 || height() < 1) return;
  const auto graphics = scene::makeRenderer(scene::RendererChoice::Software);
  const auto alone = instrumentOn(themeOf(*this).window.background);
  // Drawn at twice the size at which it is shown, for smooth edges.
  const QSize pixels = 2.0 * devicePixelRatioF() * size();
  const auto instrument = scene::placeOf(alone.shots.front(), pixels);
  picture_ = graphics.renderer->draw(alone, pixels).copy(instrument);
  update();
}

void ToolPicture::paintEvent(QPaintEvent* /*event*/) {
  if (picture_.isNull()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  QRect place(QPoint(0, 0), picture_.size().scaled(size(), Qt::KeepAspectRatio));
  place.moveCenter(rect().center());
  painter.drawImage(place, picture_);
}

}  // namespace study::gui
