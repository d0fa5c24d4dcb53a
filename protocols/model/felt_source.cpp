#include "protocols/model/felt_source.h"

namespace protocols {

std::string originInWords(const FeltSource& source) {
  std::string words;
  for (const auto& part : source.origin) {
    words += (words.empty() ? "" : ", ") + base::describe(part);
  }
  return words;
}

std::string inWords(const FeltSource& source) {
  std::string words = source.isSynthetic ? "SYNTHETIC: " : "";
  words += base::describe(source.title) + " (" + source.kind;
  words += source.file.empty() ? ", built into the program)" : " '" + source.file + "')";
  return source.origin.empty() ? words : words + ", " + originInWords(source);
}

}  // namespace protocols
