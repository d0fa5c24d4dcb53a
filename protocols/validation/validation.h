#pragma once

#include "protocols/model/loaded_protocol.h"
#include "protocols/reading/protocol_file.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// Everything that does not fit together in a protocol and the files that it names: names of things
/// that do not exist, something felt before consent, orders that refer to each other, a scene that
/// cannot be compiled. What is merely unwise is said by addWarnings(). What could not be read is a
/// problem already, and nothing is said about it or what follows from it.
void validate(const Draft& draft, questionnaires::Problems& problems);

/// What is wrong about a protocol's analysis plan and the truth of its simulation.
void validateAnalysis(const Draft& draft, questionnaires::Problems& problems);

/// What is wrong about a protocol's blocks, their orders, their questionnaires, and the preferences
/// asked about them.
void validateBlocks(const Draft& draft, questionnaires::Problems& problems);

/// What is merely unwise about a protocol, as warnings: a statement about the previous alternative
/// where there is none, an order that is the same for all, a number of participants that does
/// not balance, forms that are still to be filled in, things that are not used.
///
/// @param loaded  sound: validate() has nothing to say.
void addWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// What is unwise about the blocks of a sound protocol: their orders, and the statements that are
/// asked after their conditions.
void addBlockWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// What is unwise about the comparisons that are planned, or about planning none.
void addAnalysisWarnings(const Protocol& protocol, questionnaires::Problems& problems);

/// What is unwise about the scenes of a sound protocol: a filter that listens to one of its two
/// forces only, an opening that gives back more than closing took.
void addSceneWarnings(const Protocol& protocol, questionnaires::Problems& problems);

}  // namespace protocols
