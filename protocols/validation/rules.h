#pragma once

#include "protocols/reading/draft.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// Everything that does not fit together in a protocol and the files that it names: names of things
/// that do not exist, something felt before consent, orders that refer to each other, a scene that
/// cannot be compiled. What is merely unwise is said by advise().
///
/// @param problems  what the reading has found; it is not said again in other words.
void checkRules(const Draft& draft, questionnaires::Problems& problems);

}  // namespace protocols
