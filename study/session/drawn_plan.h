#pragma once

#include <vector>

#include "study/model/session_plan.h"
#include "study/session/study.h"

namespace study {

/// The steps of a session, with the conditions that were drawn for it.
///
/// The seed draws a schedule for the session's place in the design. In live and pilot sessions of a
/// study with a secret, conditions are then permuted: the secret replaces, for example, "a" by "c"
/// in the schedules of all participants of that run mode. The permutation keeps every design
/// balanced, and hides the conditions from readers who know the seed. Only conditions of the same
/// blocks are exchanged. Conditions are not permuted if the protocol itself fixes them: by a
/// "seed", by labels that are the names of conditions, or in blocks with a fixed order.
/// @throws storage::StorageError  if the secret is not this study's, or is not available on this
///     computer.
std::vector<Step> drawnPlan(Study& study, const storage::SessionRow& row);

/// Value in the first event of a station's trail: the station draws its orders with its own secret,
/// so that no other station can compute them.
inline constexpr const char* kOrdersOfStation = "orders";

/// The steps as stations of earlier releases drew them: from the study's seed, which all stations
/// know.
std::vector<Step> planFromStudySeed(Study& study, const storage::SessionRow& row);

/// The steps of a session without conditions and sets of items, which need the secret. They are
/// enough to show the session's progress. @throws storage::StorageError
std::vector<Step> planWithoutConditions(Study& study, const storage::SessionRow& row);

}  // namespace study
