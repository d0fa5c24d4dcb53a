#pragma once

#include "protocols/model/loaded_protocol.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// What is unwise about the scenes of a sound protocol: a filter that listens to one of its two
/// forces only, an opening that gives back more than closing took.
void adviseOnScenes(const Protocol& protocol, questionnaires::Problems& problems);

}  // namespace protocols
