#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "questionnaires/model/answer.h"

namespace questionnaires {

/// Whether one person's answers contradict each other, by the rule of their instrument.
struct Consistency {
  std::vector<std::string> contradictory;  ///< ids of the scores whose answers lie too far apart
  bool isSuspicious = false;               ///< there are as many of them as the rule says
  std::string warning;                     ///< in words; empty where nothing is suspicious
};

/// Looks at @p answers by the ConsistencyRule of @p instrument; nothing where it has none.
///
/// Within each score of the rule the keyed answers should lie close together, since its items ask
/// about one thing. A range (largest - smallest) above ConsistencyRule::widestRange is a
/// contradiction. Suspicious answers are told and never dropped: that is for the researcher to
/// decide. For the UEQ: a range above 3 in at least three of six scales (UEQ handbook, data
/// analysis tool).
std::optional<Consistency> consistencyOf(
    const Instrument& instrument, const std::vector<Answer>& answers);

}  // namespace questionnaires
