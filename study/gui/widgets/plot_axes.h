#pragma once

#include <initializer_list>

#include <qcustomplot.h>

#include "study/gui/widgets/theme.h"

namespace study::gui {

/// Gives the background of @p plot, and @p axes with their grids, the colours of a theme.
void paintAxes(QCustomPlot& plot, const Theme& colours, std::initializer_list<QCPAxis*> axes);

}  // namespace study::gui
