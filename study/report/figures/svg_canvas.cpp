#include "study/report/figures/svg_canvas.h"

#include <QBuffer>
#include <QFont>
#include <QSvgGenerator>

namespace study::report {

std::string asSvg(const QSizeF& size, const std::function<void(QPainter&)>& paint) {
  QBuffer buffer;
  QSvgGenerator generator;
  generator.setOutputDevice(&buffer);
  generator.setResolution(96);
  generator.setSize(size.toSize());
  generator.setViewBox(QRectF(QPointF(0, 0), size));
  {
    QPainter painter(&generator);
    painter.setRenderHint(QPainter::Antialiasing);
    paint(painter);
  }
  const std::string svg = buffer.data().toStdString();
  const auto begin = svg.find("<svg");
  return begin == std::string::npos ? std::string() : svg.substr(begin);
}

void drawText(
    QPainter& painter,
    const QRectF& where,
    int flags,
    const QString& text,
    double size,
    bool isBold) {
  constexpr double kScale = 10.0;
  QFont font(QStringLiteral("DejaVu Sans"));
  font.setPixelSize(static_cast<int>(size * kScale));
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
