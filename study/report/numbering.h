#pragma once

#include <string>

#include "study/words/words.h"

namespace study::report {

/// Numbers tables and figures in the order of a page with several studies; those of appendixes
/// separately, from A1. A caption may have a key, <caption id="answer">, to which
/// <a href="#answer"></a> of the same text refers. For example, the table gets the id "table-3",
/// its caption begins with "Table 3.", and the reference reads "Table 3".
class Numbering {
 public:
  /// @throws std::logic_error  if no caption has the key of a reference.
  std::string numbered(const std::string& html, const words::Words& words);

 private:
  struct Counts {
    int tables = 0;
    int figures = 0;
  };
  Counts main_;
  Counts appendix_;
};

}  // namespace study::report
