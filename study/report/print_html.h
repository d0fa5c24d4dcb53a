#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace study::report {

/// A page as a rich-text engine without HTML 5 understands it.
struct PrintHtml {
  std::string html;
  std::vector<std::string> figures;  ///< SVG; in the text stand <img src="figure:0"> and so on
};

/// Takes the figures out of a page of ours, and says with older marks what newer ones say: captions
/// in the heads of their tables, names to the left and numbers to the right.
PrintHtml forPrint(std::string_view html);

}  // namespace study::report
