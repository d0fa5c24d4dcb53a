#pragma once

#include <string>
#include <vector>

#include "protocols/model/protocol.h"

namespace protocols {

/// A place where a protocol names an instrument.
struct InstrumentUse {
  std::string instrument;
  std::string path;  ///< of the name: "$.phases[1].instrument"
  PhaseType phase = PhaseType::Information;
};

/// All of them, in the order of the session.
std::vector<InstrumentUse> instrumentUses(const Protocol& protocol);

}  // namespace protocols
