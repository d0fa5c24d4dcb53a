#pragma once

#include "protocols/loaded_protocol.h"
#include "questionnaires/problem.h"

namespace protocols {

/// Everything that does not fit together in a protocol whose files are all read: names of things
/// that do not exist, something felt before consent, orders that refer to each other, a scene that
/// cannot be compiled. What is merely unwise is a warning: a statement about the previous
/// alternative where there is none, an order that is the same for everybody, a number of
/// participants that does not balance.
void checkRules(const LoadedProtocol& loaded, questionnaires::Problems& problems);

}  // namespace protocols
