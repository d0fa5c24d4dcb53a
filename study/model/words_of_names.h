#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace study {

/// The words of @p text with at least three letters, or two if the first is a capital. Latin
/// letters become lower-case without diacritics ("Åsgård" becomes "asgard"); letters of other
/// alphabets are unchanged.
std::vector<std::string> wordsIn(std::string_view text);

}  // namespace study
