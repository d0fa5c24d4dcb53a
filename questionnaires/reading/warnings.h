#pragma once

#include <array>
#include <cstddef>
#include <utility>

#include "base/message.h"

namespace questionnaires {

/// What an instrument's author is warned of, and what to do about it: "key" and "key.fix".
inline constexpr auto kWarnings = std::to_array<base::MessageKind>({
    {"compares_with_previous", "this compares with what was felt just before"},
    {"compares_with_previous.fix",
     "an order must give it a predecessor: whatever is felt first has none"},
    {"different_ranges", "these items are answered on different ranges"},
    {"different_ranges.fix", "the widest weighs most: is that meant?"},
    {"some_pairs_asked", "{} of the {} pairs are asked"},
    {"some_pairs_asked.fix", "some items can gather more weight than others: is that meant?"},
    {"language_not_listed", "a text in '{}', which is not among the languages of the instrument"},
    {"language_not_listed.fix", "add '{}' to $.languages, or remove the text"},
    {"blank_left", "still to be filled in: {}"},
    {"blank_left.fix", "copy the instrument into the study's folder and write what holds there"},
});

/// One of them, with its arguments.
template <typename... Arguments>
base::Message warning(base::KeyIn<kWarnings, sizeof...(Arguments)> key, Arguments&&... arguments) {
  return base::messageOf<kWarnings>(key, std::forward<Arguments>(arguments)...);
}

}  // namespace questionnaires
