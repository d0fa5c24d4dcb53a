#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace study {

/// The words of @p text with at least three letters, or two if the first is a capital. Latin
/// letters become lower-case without diacritics ("Åsgård" becomes "asgard"), and letters that stand
/// for one with a mark become that one ("Aasgaard" and "Müller" or "Mueller", too); letters of
/// other alphabets are unchanged.
std::vector<std::string> wordsIn(std::string_view text);

/// The first word of @p text, as it is written there, that is a word of @p name, or begins with one
/// of at least four letters ("Hübners"). Empty if there is none.
std::string wordNaming(std::string_view text, std::string_view name);

}  // namespace study
