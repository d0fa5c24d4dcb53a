#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace study::report {

/// A page in the HTML that Qt's rich-text engine understands.
struct PrintHtml {
  std::string html;
  std::string language = "en";
  std::string foot = {};             ///< of every page, see htmlPage(); plain text
  std::vector<std::string> figures;  ///< SVG; the text has <img src="figure:0">, … for them
};

/// Extracts the figures of a page (html_report.h, document.h) and replaces markup that Qt does not
/// know: captions become rows of table heads, names are aligned left and numbers right.
/// @param scale  of all font sizes.
PrintHtml toPrintHtml(std::string_view html, double scale = 1.0);

}  // namespace study::report
