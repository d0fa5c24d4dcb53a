#pragma once

#include <string>

#include "study/words/words.h"

namespace study::report {

/// Numbers tables and figures in the order of a page, over several studies; those of appendixes by
/// themselves, from A1. A caption may have a
/// key, <caption id="answer">, to which <a href="#answer"></a> of the same text refers. Then the
/// table has the id "table-3", its caption begins with "Table 3.", and the reference reads
/// "Table 3". A reference to a key that no caption has is an error of ours.
class Numbering {
 public:
  /// @throws std::logic_error  for a reference without its caption.
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
