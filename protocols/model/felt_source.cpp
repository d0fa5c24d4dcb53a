#include "protocols/model/felt_source.h"

namespace protocols {

std::string inWords(const FeltSource& source) {
  std::string words = source.isSynthetic ? "SYNTHETIC: " : "";
  words += source.title + " (" + source.kind;
  words += source.file.empty() ? ", built into the program)" : " '" + source.file + "')";
  return source.origin.empty() ? words : words + ", " + source.origin;
}

}  // namespace protocols
