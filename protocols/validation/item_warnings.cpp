#include <algorithm>
#include <set>
#include <string>

#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"

namespace protocols {
namespace {

using questionnaires::Instrument;
using questionnaires::Item;

/// Whether a family compares the answers to @p item.
bool isCompared(const Protocol& protocol, const Instrument& instrument, const Item& item) {
  return std::ranges::any_of(protocol.analysis.families, [&](const auto& family) {
    return family.instrument == instrument.id && !comparedItems(family, {item}).empty();
  });
}

bool isScored(const Instrument& instrument, const std::string& item) {
  return std::ranges::any_of(instrument.scores, [&](const auto& score) {
    return std::ranges::count(score.items, item) > 0 ||
           std::ranges::count(score.weightsFrom, item) > 0;
  });
}

/// The items whose answers are numbers that nothing is computed from: "ease, effort".
std::string unusedItems(const Protocol& protocol, const Instrument& instrument) {
  std::string ids;
  for (const auto& item : instrument.items) {
    const bool isUsed = !questionnaires::rangeOf(item) || item.acceptableFrom ||
                        isScored(instrument, item.id) || isCompared(protocol, instrument, item);
    if (!isUsed) ids += (ids.empty() ? "" : ", ") + item.id;
  }
  return ids;
}

}  // namespace

void addItemWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems) {
  const auto& protocol = loaded.protocol;
  if (protocol.analysis.families.empty()) return;  // has a warning of its own
  std::set<std::string> told;
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) {
    const auto& asked = protocol.phases[i].trials.questionnaires;
    for (std::size_t j = 0; j < asked.size(); ++j) {
      if (!told.insert(asked[j].instrument).second) continue;
      const auto ids = unusedItems(protocol, *loaded.instrument(asked[j].instrument));
      if (ids.empty()) continue;
      problems.warn(
          "$.phases[" + std::to_string(i) + "].questionnaires[" + std::to_string(j) + "]",
          message("items_not_analysed", asked[j].instrument, ids),
          message("items_not_analysed.fix"));
    }
  }
}

}  // namespace protocols
