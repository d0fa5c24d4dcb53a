#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "protocols/model/loaded_protocol.h"
#include "protocols/model/protocol.h"
#include "protocols/reading/protocol_file.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// Reports inconsistencies of a protocol and the files that it names: names that do not exist, a
/// trial before consent, orders that refer to each other, a scene that cannot be compiled.
/// addWarnings() reports doubtful but valid designs. Nothing is reported about parts that could not
/// be read, or about their consequences, because they have a problem already.
void validate(const Draft& draft, questionnaires::Problems& problems);

/// Reports problems of a protocol's analysis plan and of its simulation.
void validateAnalysis(const Draft& draft, questionnaires::Problems& problems);

/// Reports problems of a protocol's blocks, their orders, their questionnaires, and the preferences
/// between their alternatives.
void validateBlocks(const Draft& draft, questionnaires::Problems& problems);

/// Reports questions about a benchmark that no earlier phase contains. Not called for studies of
/// release 0.1, whose protocols stay valid.
void validateBenchmarks(const Draft& draft, questionnaires::Problems& problems);

/// Reports force limits above what a hand bears without pain or above what the kind of device
/// gives, and rate limits too high to have an effect. Called only for protocol files: an existing
/// study keeps its limits.
void validateLimits(const Protocol& protocol, questionnaires::Problems& problems);

/// Adds warnings about doubtful designs: a statement about the previous alternative when there is
/// none, one order for all, a number of participants that does not balance, forms with
/// placeholders, unused parts.
///
/// @param loaded    must have passed validate() without problems.
/// @param defaults  studies of release 0.1 keep the warnings of that release.
void addWarnings(
    const LoadedProtocol& loaded, questionnaires::Problems& problems, Defaults defaults);

/// Adds warnings about the blocks of a valid protocol: their orders, and the statements after their
/// conditions.
void addBlockWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// Adds warnings about numeric items asked after conditions that no family, score or threshold
/// uses.
void addItemWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// Adds warnings about questions after conditions whose scenes do not render what is asked about:
/// vibration, the pace of removal, the size of forces.
void addReferentWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// Adds warnings about families that declare a test of pooled answers as confirmatory.
void addPoolingWarnings(const Protocol& protocol, questionnaires::Problems& problems);

/// Adds warnings about the planned comparisons, or a missing plan.
void addAnalysisWarnings(const Protocol& protocol, questionnaires::Problems& problems);

/// Adds warnings about everything in a valid protocol that identifies the condition of an answer,
/// so that no export of the study is blinded.
void addBlindingWarnings(const Protocol& protocol, questionnaires::Problems& problems);

/// Adds warnings about the scenes of a valid protocol: a filter that ignores one of its two forces,
/// an opening that returns more energy than closing took.
void addSceneWarnings(const Protocol& protocol, questionnaires::Problems& problems);

/// A place in a protocol that discloses the condition of an answer although the condition is coded.
struct Disclosure {
  std::string path;    ///< a JSON path from the root: "$.phases[3].order"
  base::Message what;  ///< what discloses the condition
  base::Message fix;   ///< how to change the protocol to prevent it
};

/// All disclosures, in the order of the protocol. If empty, an export of the study can be blinded.
///
/// For each answer, a blinded export contains the block, the position in it, the number of the
/// alternative and the statement. From these, a reader who also has the protocol must not be able
/// to infer the condition (docs/decisions/0033). What the answers themselves reveal is not checked.
/// @param protocol  must be valid.
std::vector<Disclosure> disclosuresOf(const Protocol& protocol);

}  // namespace protocols
