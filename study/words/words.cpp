#include "study/words/words.h"

namespace study::words {

const std::string& Words::operator()(std::string_view english) const {
  const auto found = catalogue_.find(english);
  if (found != catalogue_.end()) return found->second;
  return *missing_.emplace(english).first;
}

std::string Words::known(std::string_view words) const {
  const auto found = catalogue_.find(words);
  return found != catalogue_.end() ? found->second : std::string(words);
}

}  // namespace study::words
