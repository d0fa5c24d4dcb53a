#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "questionnaires/model/answer.h"

namespace questionnaires {

/// How many participants found what an item asks about acceptable.
struct Acceptability {
  std::string itemId;
  double acceptableFrom = 0.0;  ///< the threshold, on the item's own scale
  std::size_t acceptable = 0;   ///< participants whose keyed answer is at or above it
  std::size_t answered = 0;     ///< participants who answered the item
  std::optional<double> share;  ///< acceptable / answered, 0 … 1
  std::string reason;           ///< why there is no share; empty where there is one
};

/// For every item of @p instrument that has a threshold, in its order: the share of participants at
/// or above it. @p participants holds the answers of each; who left the item open is not counted.
/// An answer to an item with key -1 is turned round first.
std::vector<Acceptability> acceptabilityOf(
    const Instrument& instrument, const std::vector<std::vector<Answer>>& participants);

}  // namespace questionnaires
