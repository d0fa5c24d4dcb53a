#pragma once

#include "protocols/model/loaded_protocol.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// What is merely unwise about a protocol, as warnings: a statement about the previous alternative
/// where there is none, an order that is the same for everybody, a number of participants that does
/// not balance, forms that are still to be filled in, things that nobody uses.
///
/// @param loaded  sound: checkRules() has nothing to say.
void advise(const LoadedProtocol& loaded, questionnaires::Problems& problems);

}  // namespace protocols
