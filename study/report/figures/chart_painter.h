#pragma once

#include <string>

#include "study/report/chart.h"

namespace study::report {

/// A chart as an SVG element to embed in a page. Needs a QGuiApplication.
std::string chartAsSvg(const Chart& chart);

}  // namespace study::report
