#pragma once

#include <string>
#include <string_view>

namespace study::report {

/// Text escaped for an HTML element or attribute.
std::string escaped(std::string_view text);

/// Text with typographic quotation marks and apostrophes in place of straight single ones.
std::string withCurlyQuotes(std::string_view text);

/// Escaped text with "p_Holm", "g_z" and "BF10" as subscripts.
std::string withSubscripts(std::string html);

/// A complete self-contained page: @p body with the style sheet of all our reports.
/// @param foot  printed at the foot of every page of the PDF, before the page's number
std::string htmlPage(
    std::string_view title,
    std::string_view body,
    std::string_view language = "en",
    std::string_view foot = {});

}  // namespace study::report
