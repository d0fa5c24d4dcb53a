#pragma once

#include <string>
#include <string_view>
#include <vector>

#include <QFont>
#include <QPainter>
#include <QSvgRenderer>
#include <QTransform>

namespace study::report {

QByteArray bytesOf(std::string_view text);

/// The typeface of reports and their figures: Carlito if it is installed (the package depends on
/// it), otherwise DejaVu Sans.
const QString& typeface();

/// A font in which words can be searched and copied: letter spacing turns ligatures off, most of
/// which are no characters of their own (Qt 6.4).
QFont withoutLigatures(QFont font);

/// Draws a figure of asSvg() with its text as text, which can be searched and copied. Qt's renderer
/// draws every letter as an outline (Qt 6.4).
class FigureDrawing {
 public:
  explicit FigureDrawing(std::string_view svg);

  /// [px at 96 dpi]
  QSizeF size() const { return lines_.viewBoxF().size(); }
  void draw(QPainter& painter, const QRectF& where);

 private:
  struct Text {
    QTransform place;  ///< from the text's coordinates to those of the figure
    QPointF start;     ///< of its base line
    QFont font;
    QColor colour;
    QString words;
  };

  QSvgRenderer lines_;  ///< everything but the text
  std::vector<Text> texts_;
};

}  // namespace study::report
