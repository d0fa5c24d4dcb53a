#pragma once

#include <functional>
#include <string>

#include <QPainter>
#include <QSizeF>

#include "study/report/figures/figure_format.h"

namespace study::report {

/// Calls @p paint with a canvas of @p size [px at 96 dpi] and returns the picture as an SVG element
/// to embed in a page. Needs a QGuiApplication (the offscreen platform is enough).
/// @param format  the size on paper; its layoutWidth() has to be the width of @p size.
std::string asSvg(
    const QSizeF& size,
    const std::function<void(QPainter&)>& paint,
    const FigureFormat& format = {});

/// Draws text 13 px high, whose position does not depend on the device. Qt rounds font sizes to
/// whole device pixels, so the text is drawn ten times larger on a canvas that is scaled by a
/// tenth.
void drawText(
    QPainter& painter, const QRectF& where, int flags, const QString& text, bool isBold = false);

}  // namespace study::report
