#pragma once

#include <vector>

#include "study/model/session_plan.h"
#include "study/session/study.h"

namespace study {

/// The steps of a session, as they were drawn for it.
///
/// The seed draws a schedule for the session's place. In live and pilot sessions of a study with a
/// secret, conditions then change parts: one that the seed calls "a" is everywhere "c", for all
/// participants of that run mode. That keeps every design balanced, and hides from anyone who knows
/// the seed what was felt. Conditions stay as the seed has them where the protocol itself promises
/// which is which: with a seed of its own, with labels that stand for conditions, in blocks of a
/// fixed order. They change parts only with conditions of the same blocks.
/// @throws storage::StorageError  if the study's secret is not the one that it was made with, or is
///     kept elsewhere.
std::vector<Step> drawnPlan(Study& study, const storage::SessionRow& row);

/// A station draws with its secret, so that no other can compute its orders, and says so in the
/// first event of its trail. The value's name there:
inline constexpr const char* kOrdersOfStation = "orders";

/// The steps as stations drew them that did not yet: from the study's seed, which all have.
std::vector<Step> planOfEarlierStation(Study& study, const storage::SessionRow& row);

/// The same steps for those who only want to know where a session stands: without conditions and
/// sets of items, which need the secret. @throws storage::StorageError
std::vector<Step> planWithoutConditions(Study& study, const storage::SessionRow& row);

}  // namespace study
