#pragma once

#include <string>

#include "study/report/chart.h"
#include "study/report/figures/figure_format.h"

namespace study::report {

/// A chart as an SVG element to embed in a page. Needs a QGuiApplication.
std::string chartAsSvg(const Chart& chart, const FigureFormat& format = {});

}  // namespace study::report
