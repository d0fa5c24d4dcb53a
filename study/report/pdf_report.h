#pragma once

#include <string>
#include <string_view>

namespace study::report {

/// A page of ours (html_report.h, document.h) on A4 paper, as a PDF file's bytes: text as text,
/// figures as vectors, pages numbered. Needs a QGuiApplication.
std::string asPdf(std::string_view html, std::string_view title);

/// A figure alone, as large as it is.
std::string figureAsPdf(std::string_view svg);

/// A figure alone, at 300 dpi, as a PNG file's bytes.
std::string figureAsPng(std::string_view svg);

}  // namespace study::report
