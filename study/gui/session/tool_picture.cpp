#include "study/gui/session/tool_picture.h"

#include <algorithm>
#include <cmath>
#include <cstdint>

#include <QFrame>
#include <QPainter>
#include <QTimer>
#include <QVBoxLayout>

#include "study/gui/scene/hip_scene.h"
#include "study/gui/scene/knee_scene.h"
#include "study/gui/scene/renderer.h"
#include "study/gui/widgets/theme.h"

namespace study::gui {
namespace {

using haptics::devices::View;

constexpr QSize kUsual(560, 300);   // [px] at scale 1
constexpr int kRendererDelay = 20;  // [ms]

/// A view of the whole instrument without what it touches.
scene::Scene instrumentIn(View view, InstrumentIs instrument) {
  if (view != View::Hip) {
    const scene::KneeScene knee;
    auto alone = knee.scene();
    alone.shots = {
        instrument == InstrumentIs::Real ? knee.wholeInstrument() : knee.handleOfInstrument()};
    return alone;
  }
  const scene::HipScene hip(scene::HipScene::Options{});
  auto alone = hip.scene();
  auto& shot = alone.shots.front();
  std::erase_if(shot.parts, [&](std::size_t part) { return !alone.parts[part].isTool; });
  shot.showsSpheres = false;
  return alone;
}

/// The instrument without the ground that it was drawn on.
QImage cutOut(const QImage& picture, const QColor& ground) {
  QImage alone = picture.convertToFormat(QImage::Format_ARGB32);
  const QRgb behind = ground.rgb();
  for (int y = 0; y < alone.height(); ++y) {
    auto* line = reinterpret_cast<QRgb*>(alone.scanLine(y));
    std::replace(line, line + alone.width(), behind, qRgba(255, 255, 255, 0));
  }
  return alone;
}

/// @p picture, a mask, with each pixel the mean of those around it.
QImage blurred(const QImage& picture) {
  constexpr int kReach = 2;  // [px]
  QImage soft(picture.size(), QImage::Format_Alpha8);
  for (int y = 0; y < picture.height(); ++y) {
    for (int x = 0; x < picture.width(); ++x) {
      int sum = 0;
      for (int v = y - kReach; v <= y + kReach; ++v) {
        if (v < 0 || v >= picture.height()) continue;
        const uchar* line = picture.constScanLine(v);
        for (int u = std::max(0, x - kReach); u <= std::min(picture.width() - 1, x + kReach); ++u) {
          sum += line[u];
        }
      }
      constexpr int kNeighbours = (2 * kReach + 1) * (2 * kReach + 1);
      soft.scanLine(y)[x] = static_cast<uchar>(sum / kNeighbours);
    }
  }
  return soft;
}

/// The soft shadow of @p instrument, in a picture of the same size.
QImage shadowOf(const QImage& instrument) {
  constexpr int kCoarse = 6;  // [px]: a shadow needs no fine pixels
  constexpr double kDepth = 0.3;
  const QImage mask =
      instrument
          .scaled(instrument.size() / kCoarse, Qt::IgnoreAspectRatio, Qt::SmoothTransformation)
          .convertToFormat(QImage::Format_Alpha8);
  const QImage soft = blurred(blurred(mask)).convertToFormat(QImage::Format_ARGB32);
  QImage shadow = soft.scaled(instrument.size(), Qt::IgnoreAspectRatio, Qt::SmoothTransformation);
  QPainter painter(&shadow);
  painter.setCompositionMode(QPainter::CompositionMode_DestinationIn);
  painter.fillRect(shadow.rect(), QColor(0, 0, 0, static_cast<int>(255.0 * kDepth)));
  return shadow;
}

}  // namespace

ToolPicture::ToolPicture(
    const haptics::devices::DeviceKind& device, InstrumentIs instrument, QWidget* parent)
    : QWidget(parent), view_(device.view), instrument_(instrument) {
  setProperty("role", QStringLiteral("plain"));
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
}

QSize ToolPicture::sizeHint() const {
  return {scaled(*this, kUsual.width()), scaled(*this, kUsual.height())};
}

void ToolPicture::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  picture_ = {};
  QTimer::singleShot(kRendererDelay, this, [this] { draw(); });
}

/// The picture that was drawn last: the pages of a session show the same one.
struct LastDrawn {
  View view = View::None;
  InstrumentIs instrument = InstrumentIs::Real;
  QSize size;
  QColor ground;
  QImage picture;
};

static LastDrawn& lastDrawn() {
  static LastDrawn last;
  return last;
}

void ToolPicture::draw() {
  if (!picture_.isNull() || width() < 1 || height() < 1) return;
  const auto ground = themeOf(*this).field.background;
  auto& last = lastDrawn();
  const auto size = devicePixelRatioF() * this->size();
  const bool isSame = last.view == view_ && last.instrument == instrument_ && last.size == size &&
                      last.ground == ground;
  if (!isSame) last = {view_, instrument_, size, ground, drawn(ground)};
  picture_ = last.picture;
  update();
}

QImage ToolPicture::drawn(const QColor& ground) const {
  auto alone = instrumentIn(view_, instrument_);
  alone.ground = {
      static_cast<std::uint8_t>(ground.red()),
      static_cast<std::uint8_t>(ground.green()),
      static_cast<std::uint8_t>(ground.blue()),
      0};
  constexpr double kShareOfWidget = 0.94;  // leaves room for the shadow
  const QSizeF all = devicePixelRatioF() * QSizeF(size());
  const QSizeF shown = kShareOfWidget * all;
  // Drawn at twice the size at which it is shown, for smooth edges, but not at every cost.
  constexpr double kMost = 4e6;  // pixels
  const double fine = std::min(2.0, std::sqrt(kMost / (shown.width() * shown.height())));
  const QSize pixels = (fine * shown).toSize().expandedTo({1, 1});
  const auto graphics = scene::makeRenderer(scene::RendererChoice::Software);
  const auto place = scene::placeOf(alone.shots.front(), pixels);
  const auto drawn = cutOut(graphics.renderer->draw(alone, pixels).copy(place), ground)
                         .scaled(
                             (QSizeF(place.size()) / fine).toSize(),
                             Qt::IgnoreAspectRatio,
                             Qt::SmoothTransformation);
  QImage instrument(all.toSize(), QImage::Format_ARGB32_Premultiplied);
  instrument.fill(Qt::transparent);
  const QPoint corner(
      (instrument.width() - drawn.width()) / 2, (instrument.height() - drawn.height()) / 2);
  QPainter(&instrument).drawImage(corner, drawn);
  QImage picture(instrument.size(), QImage::Format_ARGB32_Premultiplied);
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  constexpr double kShadowOffset = 0.015;  // of the height: how far the shadow falls
  painter.drawImage(QPointF(0.0, kShadowOffset * instrument.height()), shadowOf(instrument));
  painter.drawImage(0, 0, instrument);
  return picture;
}

void ToolPicture::paintEvent(QPaintEvent* /*event*/) {
  if (picture_.isNull()) return;
  QPainter painter(this);
  painter.setRenderHint(QPainter::SmoothPixmapTransform);
  painter.drawImage(rect(), picture_);
}

QWidget* toolCardOf(
    const haptics::devices::DeviceKind& device, InstrumentIs instrument, QWidget* parent) {
  if (device.view == View::None) return nullptr;
  auto* card = new QFrame(parent);
  card->setProperty("role", QStringLiteral("card"));
  auto* inside = new QVBoxLayout(card);
  const int side = scaled(*parent, 28);
  inside->setContentsMargins(side, side, side, side);
  inside->addWidget(new ToolPicture(device, instrument, card));
  return card;
}

}  // namespace study::gui
