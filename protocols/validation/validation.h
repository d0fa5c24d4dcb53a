#pragma once

#include <string>
#include <vector>

#include "base/message.h"
#include "protocols/model/loaded_protocol.h"
#include "protocols/model/protocol.h"
#include "protocols/reading/protocol_file.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// Reports inconsistencies of a protocol and its files: names that do not exist, a trial before
/// consent, orders that refer to each other, a scene that cannot be compiled. (addWarnings()
/// reports designs that are valid but doubtful.) Nothing is reported about unreadable parts and
/// their consequences, because unreadable parts were reported already.
void validate(const UnvalidatedProtocol& draft, questionnaires::Problems& problems);

/// Reports problems of a protocol's analysis plan and of its simulation.
void validateAnalysis(const UnvalidatedProtocol& draft, questionnaires::Problems& problems);

/// Reports problems of a protocol's blocks, of their orders and questionnaires, and of preferences
/// between their alternatives.
void validateBlocks(const UnvalidatedProtocol& draft, questionnaires::Problems& problems);

/// Reports questions about a benchmark if no earlier phase is a benchmark. Not called for studies
/// of release 0.1, so that their protocols stay valid.
void validateBenchmarks(const UnvalidatedProtocol& draft, questionnaires::Problems& problems);

/// Reports what a new protocol file may not have, but an existing study keeps: force limits above
/// what a hand bears without pain or above what the kind of device can render, rate limits that are
/// too high to have an effect, two cohorts or conditions with one title, and equivalence margins
/// that no difference exceeds.
void validateNewFile(const UnvalidatedProtocol& draft, questionnaires::Problems& problems);

/// Adds warnings on doubtful designs: a statement about the previous alternative that may have
/// none, one order for all participants, a number of participants that does not balance the orders,
/// forms with placeholders, unused parts.
///
/// @param loaded  must have passed validate() without problems.
/// @param defaults  with Defaults::Release01, the warnings of release 0.1
void addWarnings(
    const LoadedProtocol& loaded, questionnaires::Problems& problems, Defaults defaults);

/// Adds warnings on the blocks of a valid protocol: on orders, and on statements after conditions.
void addBlockWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// Adds warnings on items asked in or after the first block, with answers that are numbers or
/// choices, which no family, score or threshold uses.
void addItemWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// Adds warnings on questions after a condition whose scene does not render what they ask about:
/// vibration, the pace of removal, the size of forces.
void addReferentWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// Adds warnings on families that declare a test on pooled answers as confirmatory.
void addPoolingWarnings(const Protocol& protocol, questionnaires::Problems& problems);

/// Adds warnings on the planned comparisons, or on their absence.
void addAnalysisWarnings(const Protocol& protocol, questionnaires::Problems& problems);

/// Adds warnings on scenes that give hardly any force over the travel of their device, pull the
/// hand, ask for more than the device may give (finite elements), or are those of another
/// condition.
void addForceWarnings(const Protocol& protocol, questionnaires::Problems& problems);

/// Adds warnings on the plan of a study: families with a large alpha, a twin, or a score that many
/// participants lack; questions before consent, trials after the debriefing,
/// languages that the windows lack, a date that is none.
void addPlanWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// Adds warnings on words in texts for participants: in braces that nothing fills in, or naming a
/// condition.
void addWordWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems);

/// Adds warnings on everything in a valid protocol that discloses the condition of an answer, so
/// that no export of the study is blinded.
void addBlindingWarnings(const Protocol& protocol, questionnaires::Problems& problems);

/// Adds warnings on the scenes of a valid protocol: a filter that ignores one of its two forces, an
/// opening branch with more force than the closing one, a cut beyond the device's limit, a knee
/// that is never shown, different knees in one block.
void addSceneWarnings(const Protocol& protocol, questionnaires::Problems& problems);

/// A place in a protocol that discloses the condition of an answer in spite of its code.
struct Disclosure {
  std::string path;    ///< a JSON path from the root: "$.phases[3].order"
  base::Message what;  ///< what discloses the condition
  base::Message fix;   ///< how to change the protocol to prevent it
};

/// All disclosures, in the order of the protocol. If there are none, exports of the study can be
/// blinded.
///
/// For each answer, a blinded export contains the block, the position in the block, the number of
/// the alternative, and the statement. A reader who also has the protocol must not be able to infer
/// the condition from these (docs/decisions/0033). What the answers themselves reveal is not
/// checked.
/// @param protocol  must be valid.
std::vector<Disclosure> disclosuresOf(const Protocol& protocol);

}  // namespace protocols
