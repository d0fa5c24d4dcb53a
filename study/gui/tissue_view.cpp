#include "study/gui/tissue_view.h"

#include <algorithm>
#include <utility>

#include <QPainter>
#include <QPainterPath>

namespace study::gui {
namespace {

// The picture is drawn on a canvas of 600 × 320 and fitted into the widget.
constexpr double kWide = 600.0;
constexpr double kHigh = 320.0;
constexpr double kSurface = 170.0;       // where the tissue's surface lies when nothing touches it
constexpr double kPixelsPerUnit = 11.0;  // of displacement and travel

}  // namespace

TissueView::TissueView(QWidget* parent) : QWidget(parent) {
  setMinimumHeight(220);
  setAttribute(Qt::WA_TransparentForMouseEvents);  // the page around it is the handle
}

void TissueView::show(double travel, std::vector<haptics::engine::MeshView::Point> mesh) {
  travel_ = travel;
  mesh_ = std::move(mesh);
  update();
}

void TissueView::paintEvent(QPaintEvent* /*event*/) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  const double scale = std::min(width() / kWide, height() / kHigh);
  painter.translate((width() - scale * kWide) / 2.0, (height() - scale * kHigh) / 2.0);
  painter.scale(scale, scale);
  painter.setClipRect(QRectF(0, 0, kWide, kHigh));
  painter.fillRect(QRectF(0, 0, kWide, kHigh), QColor(0x2a, 0x1c, 0x1c));
  paintTissue(painter);
  paintPunch(painter);
}

void TissueView::paintTissue(QPainter& painter) const {
  QPainterPath surface(QPointF(0, kHigh));
  surface.lineTo(0, kSurface);
  if (mesh_.size() > 1) {
    const double first = mesh_.front().position;
    const double span = mesh_.back().position - first;
    for (const auto& point : mesh_) {
      const double x = kWide * (point.position - first) / span;
      surface.lineTo(x, kSurface + kPixelsPerUnit * point.displacement);
    }
  }
  surface.lineTo(kWide, kSurface);
  surface.lineTo(kWide, kHigh);
  surface.closeSubpath();
  painter.setPen(QPen(QColor(0xf3, 0xe6, 0xd8), 3));
  painter.setBrush(QColor(0xd9, 0xbf, 0xa8));
  painter.drawPath(surface);
}

void TissueView::paintPunch(QPainter& painter) const {
  // The tool presses two thirds along the tissue; at a travel of 4 it touches the surface.
  const double x = kWide * 2.0 / 3.0;
  const double tip = kSurface + kPixelsPerUnit * (travel_ - 4.0);
  QPainterPath jaw(QPointF(x - 14, tip));
  jaw.lineTo(x + 14, tip);
  jaw.lineTo(x + 26, tip - 46);
  jaw.lineTo(x + 210, tip - 92);
  jaw.lineTo(x + 204, tip - 122);
  jaw.lineTo(x - 22, tip - 58);
  jaw.closeSubpath();
  painter.setPen(QPen(QColor(0x55, 0x5d, 0x66), 2));
  painter.setBrush(QColor(0xb9, 0xc1, 0xc9));
  painter.drawPath(jaw);
}

}  // namespace study::gui
