#pragma once

#include <functional>
#include <string>

#include <QPainter>
#include <QSizeF>

namespace study::report {

/// Lets @p paint draw on @p size [px at 96 dpi] and returns the picture as an SVG element that can
/// stand in a page. Needs a QGuiApplication (the offscreen platform will do).
std::string asSvg(const QSizeF& size, const std::function<void(QPainter&)>& paint);

/// Text whose place does not depend on the device: sizes of fonts are rounded to whole device
/// pixels, so it is drawn ten times too large on a canvas ten times too small.
void drawText(
    QPainter& painter,
    const QRectF& where,
    int flags,
    const QString& text,
    double size = 13.0,
    bool isBold = false);

}  // namespace study::report
