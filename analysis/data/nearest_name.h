#pragma once

#include <span>
#include <string>
#include <string_view>

namespace analysis {

/// Which of some names a person most probably meant: the one that takes the fewest letters to
/// insert, delete or replace (Levenshtein 1966), without regard to case. The first of several.
///
/// @param names  at least one.
std::string nearestName(std::string_view meant, std::span<const std::string> names);

/// 'I', 'F' and 'K'; of more than eight, the first eight.
std::string enumerated(std::span<const std::string> names);

}  // namespace analysis
