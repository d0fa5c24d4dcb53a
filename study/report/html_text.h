#pragma once

#include <string>
#include <string_view>

namespace study::report {

/// Words as they may stand in a page or an attribute of it.
std::string escaped(std::string_view text);

/// A whole page that needs nothing else: @p body within the style of all our reports.
std::string htmlPage(
    std::string_view title, std::string_view body, std::string_view language = "en");

}  // namespace study::report
