#include "study/report/figure_drawing.h"

#include <algorithm>

#include <QFontDatabase>
#include <QRegularExpression>
#include <QXmlStreamReader>

namespace study::report {

QByteArray bytesOf(std::string_view text) {
  return {text.data(), static_cast<qsizetype>(text.size())};
}

namespace {

/// "matrix(0.1,0,0,0.1,0,0)", as QSvgGenerator writes it at every group.
QTransform matrixOf(const QString& attribute) {
  const auto numbers = attribute.mid(7).chopped(1).split(u',');
  if (numbers.size() != 6) return {};
  const auto at = [&](int i) { return numbers[i].toDouble(); };
  return {at(0), at(1), at(2), at(3), at(4), at(5)};
}

QByteArray withoutTexts(std::string_view svg) {
  static const QRegularExpression kText(QStringLiteral("<text[^>]*>[^<]*</text>"));
  return QString::fromUtf8(bytesOf(svg)).remove(kText).toUtf8();
}

}  // namespace

const QString& typeface() {
  static const QString kTypeface = [] {
    const auto carlito = QStringLiteral("Carlito");
    const bool isInstalled = QFontDatabase::families().contains(carlito);
    return isInstalled ? carlito : QStringLiteral("DejaVu Sans");
  }();
  return kTypeface;
}

QFont withoutLigatures(QFont font) {
  constexpr double kInvisible = 0.02;  // [px]
  font.setLetterSpacing(QFont::AbsoluteSpacing, kInvisible);
  return font;
}

FigureDrawing::FigureDrawing(std::string_view svg) : lines_(withoutTexts(svg)) {
  QXmlStreamReader reader(bytesOf(svg));
  QTransform place;
  while (!reader.atEnd()) {
    if (reader.readNext() != QXmlStreamReader::StartElement) continue;
    const auto attributes = reader.attributes();
    const auto valueOf = [&](const char* name) {
      return attributes.value(QLatin1String(name)).toString();
    };
    if (attributes.hasAttribute(QLatin1String("transform"))) place = matrixOf(valueOf("transform"));
    if (reader.name() != QLatin1String("text")) continue;
    QFont font(valueOf("font-family"));
    font.setPixelSize(std::max(1, valueOf("font-size").toInt()));
    font.setBold(valueOf("font-weight").toInt() > QFont::Medium);
    font.setHintingPreference(QFont::PreferNoHinting);
    texts_.push_back(
        {place,
         {valueOf("x").toDouble(), valueOf("y").toDouble()},
         withoutLigatures(font),
         QColor(valueOf("fill")),
         reader.readElementText()});
  }
}

void FigureDrawing::draw(QPainter& painter, const QRectF& where) {
  lines_.render(&painter, where);
  const QSizeF own = size();
  for (const auto& text : texts_) {
    painter.save();
    painter.translate(where.topLeft());
    painter.scale(where.width() / own.width(), where.height() / own.height());
    painter.setTransform(text.place, true);
    painter.setFont(text.font);
    painter.setPen(text.colour);
    painter.drawText(text.start, text.words);
    painter.restore();
  }
}

}  // namespace study::report
