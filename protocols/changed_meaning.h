#pragma once

#include <compare>
#include <cstddef>
#include <string>
#include <vector>

#include "base/message.h"
#include "protocols/model/loaded_protocol.h"

namespace protocols {

/// What a later version of a protocol changed in the meaning of answers to an earlier one.
struct ChangedMeaning {
  enum class Aspect {
    Scale,    ///< the points or the range of an item or a score: answers cannot be pooled
    Score,    ///< how a score is computed
    Key,      ///< whether a high answer to an item is good
    Wording,  ///< the words of an item, of its scale or its options
    Asked,    ///< whether an item is asked, or about which conditions
    Scene,    ///< what is felt as a condition
    Title,    ///< what a condition is called in results
    Order,    ///< how the orders of a block are drawn: places begin again
  };

  Aspect aspect = Aspect::Scale;
  std::string instrument;  ///< id; empty for a condition or block
  std::string id;          ///< of the item, score, condition or block

  auto operator<=>(const ChangedMeaning&) const = default;
};

/// Everything that both versions have and that means something else in @p after, sorted; and what
/// only @p after asks.
std::vector<ChangedMeaning> changedMeaning(
    const LoadedProtocol& before, const LoadedProtocol& after);

/// Whether answers to both forms of an item can be compared: they are of one kind, with the same
/// points or range.
bool haveSameScale(const questionnaires::Item& one, const questionnaires::Item& other);

/// The form of @p score, a score of @p now, in the version @p asked of its instrument; nullptr if
/// it has none, or if its values cannot be pooled: it has another range, or an item of another
/// scale.
const questionnaires::Score* comparableScore(
    const questionnaires::Instrument& asked,
    const questionnaires::Instrument& now,
    const questionnaires::Score& score);

/// "3 of 6 participants read other words: 1.1, 1.2".
/// @param ids  of the items, scores, conditions or blocks, separated by ", "
base::Message inWords(
    ChangedMeaning::Aspect aspect,
    std::size_t participants,
    std::size_t everybody,
    const std::string& ids);

}  // namespace protocols
