#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace questionnaires {

/// How many characters (code points) @p text has; nothing where it is no sound UTF-8.
///
/// Sound means what the Unicode standard means: no overlong forms, no surrogates, nothing beyond
/// U+10FFFF. An emoji with a skin tone counts as two, a letter with a combining accent as well.
std::optional<std::size_t> charactersIn(std::string_view text) noexcept;

}  // namespace questionnaires
