#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "protocols/model/protocol.h"

namespace protocols {

/// A place in a protocol that says which condition an answer is about, even where the condition
/// bears a code.
struct Disclosure {
  std::string path;    ///< a JSON path from the root: "$.phases[3].order"
  base::Message what;  ///< what says it
  base::Message fix;   ///< how the protocol would keep it
};

/// All of them, in the order of the protocol; none: an export of a study can be blinded.
///
/// A blinded export shows of each answer its block, its position there, the number of the
/// alternative and the statement. Whoever has the protocol as well must not learn the condition
/// from these (docs/decisions/0033). What answers themselves say is not judged.
/// @param protocol  sound.
std::vector<Disclosure> disclosuresOf(const Protocol& protocol);

}  // namespace protocols
