#include "study/report/figures/svg_canvas.h"

#include <fmt/format.h>

#include <QBuffer>
#include <QFont>
#include <QSvgGenerator>

#include "study/report/figure_drawing.h"

namespace study::report {

namespace {

/// Writes the exact size into the first tag of an SVG; Qt rounds it to whole pixels.
void writeSize(std::string& svg, const QSizeF& millimetres) {
  const auto replace = [&](const std::string& name, double length) {
    const auto begin = svg.find(name + "=\"");
    const auto end = svg.find('"', begin + name.size() + 2);
    svg.replace(begin, end - begin, name + "=\"" + fmt::format("{:.3f}mm", length));
  };
  replace("width", millimetres.width());
  replace("height", millimetres.height());
}

}  // namespace

std::string asSvg(
    const QSizeF& size, const std::function<void(QPainter&)>& paint, const FigureFormat& format) {
  QBuffer buffer;
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(96);
  generator.setSize((format.scale() * size).toSize());
  generator.setViewBox(QRectF(QPointF(0, 0), size));
  {
    QPainter painter(&generator);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter);
  }
  std::string svg = buffer.data().toStdString();
  const auto begin = svg.find("<svg");
  if (begin == std::string::npos) return {};
  svg.erase(0, begin);
  if (format.width) writeSize(svg, format.scale() * 25.4 / 96.0 * size);
  return svg;
}

void drawText(QPainter& painter, const QRectF& where, int flags, const QString& text, bool isBold) {
  constexpr double kScale = 10.0;
  constexpr int kSize = 13;
  QFont font(typeface());
  font.setPixelSize(static_cast<int>(kSize * kScale));
  font.setBold(isBold);
  font.setHintingPreference(QFont::PreferNoHinting);
  painter.save();
  painter.scale(1.0 / kScale, 1.0 / kScale);
  painter.setFont(font);
  painter.drawText(
      QRectF(
          where.x() * kScale, where.y() * kScale, where.width() * kScale, where.height() * kScale),
      flags,
      text);
  painter.restore();
}

}  // namespace study::report
