#pragma once

#include <string>
#include <string_view>

namespace study::report {

/// The size of a page.
enum class Paper { A4, Letter };

/// A page of html_report.h or document.h as a PDF file: text as text, figures as vectors, numbered
/// pages. Needs a QGuiApplication.
std::string asPdf(std::string_view html, std::string_view title, Paper paper = Paper::A4);

/// One figure as a PDF file whose page has the figure's size.
/// @param scale  FigureFormat::scale() of the figure.
std::string figureAsPdf(std::string_view svg, double scale = 1.0);

/// One figure at 300 dpi, as a PNG file.
std::string figureAsPng(std::string_view svg, double scale = 1.0);

}  // namespace study::report
