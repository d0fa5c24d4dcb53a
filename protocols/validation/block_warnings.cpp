#include <algorithm>
#include <set>
#include <string>

#include "base/search.h"
#include "protocols/model/messages.h"
#include "protocols/orders/schedule.h"
#include "protocols/validation/validation.h"

namespace protocols {
namespace {

using questionnaires::Problems;

/// Adds warnings on one block.
class BlockWarningCheck {
 public:
  BlockWarningCheck(const LoadedProtocol& loaded, std::size_t index, Problems& problems)
      : loaded_(loaded),
        protocol_(loaded.protocol),
        phase_(protocol_.phases[index]),
        path_("$.phases[" + std::to_string(index) + "]"),
        problems_(problems) {}

  void all() {
    for (std::size_t i = 0; i < phase_.trials.questionnaires.size(); ++i) warnOfRelativeItems(i);
    if (phase_.trials.order.type == OrderType::Fixed) {
      warnOfFixedOrder();
    } else {
      warnOfImbalance();
    }
  }

 private:
  /// Warns of statements such as "than the previous cut" for conditions that may come first.
  void warnOfRelativeItems(std::size_t index) {
    const auto& asked = phase_.trials.questionnaires[index];
    for (const auto& condition : phase_.trials.conditions) {
      if (!mayBeFirst(condition)) continue;
      const auto items = loaded_.instrument(asked.instrument)->itemsOf(asked.itemSetFor(condition));
      for (const auto& item : items) {
        if (item.comparedWith != questionnaires::Reference::Previous) continue;
        problems_.warn(
            path_ + ".questionnaires[" + std::to_string(index) + "]",
            message("no_previous", item.id, condition),
            message("no_previous.fix"));
      }
    }
  }

  bool mayBeFirst(const std::string& condition) const {
    bool isBackwards = false;
    const Phase* source = &phase_;
    while (source->trials.order.type == OrderType::Reversed) {
      source = protocol_.phase(source->trials.order.of);
      isBackwards = !isBackwards;
    }
    if (source->trials.order.type != OrderType::Fixed) return true;
    const auto& order = source->trials.conditions;
    return condition == (isBackwards ? order.back() : order.front());
  }

  void warnOfFixedOrder() {
    if (phase_.trials.conditions.size() < 2) return;
    problems_.warn(path_ + ".order", message("same_order"), message("same_order.fix"));
  }

  void warnOfImbalance() {
    const auto k = static_cast<int>(phase_.trials.conditions.size());
    const auto rows = rowsOf(phase_.trials.order.type, k).size();
    if (rows == 0) return;  // the order is drawn, or is that of another block
    for (const auto& cohort : protocol_.cohorts) {
      if (static_cast<std::size_t>(cohort.planned) % rows == 0) continue;
      problems_.warn(
          path_ + ".order",
          message("not_balanced", cohort.planned, cohort.id),
          message("not_balanced.fix", rows));
    }
  }

  const LoadedProtocol& loaded_;
  const Protocol& protocol_;
  const Phase& phase_;
  std::string path_;
  Problems& problems_;
};

/// Whether @p phase asks different statements of the family's instrument about its conditions.
bool hasUnlikeStatements(const Family& family, const Phase& phase) {
  std::set<std::string> sets;
  for (const auto& asked : phase.trials.questionnaires) {
    if (asked.instrument != family.instrument) continue;
    for (const auto& condition : phase.trials.conditions) sets.insert(asked.itemSetFor(condition));
  }
  return sets.size() > 1;
}

}  // namespace

void addBlockWarnings(const LoadedProtocol& loaded, Problems& problems) {
  const auto& phases = loaded.protocol.phases;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (phases[i].type == PhaseType::Block) BlockWarningCheck(loaded, i, problems).all();
  }
}

void addAnalysisWarnings(const Protocol& protocol, Problems& problems) {
  const auto& families = protocol.analysis.families;
  if (families.empty()) {
    problems.warn("$.analysis", message("no_family"), message("no_family.fix"));
  }
  for (std::size_t i = 0; i < families.size(); ++i) {
    const auto unlike = std::ranges::find_if(protocol.phases, [&](const auto& phase) {
      return families[i].usesBlock(phase.id) && hasUnlikeStatements(families[i], phase);
    });
    if (unlike == protocol.phases.end()) continue;
    problems.warn(
        "$.analysis.families[" + std::to_string(i) + "]",
        message("unlike_statements", unlike->id),
        message("unlike_statements.fix"));
  }
}

void addPoolingWarnings(const Protocol& protocol, Problems& problems) {
  const auto& families = protocol.analysis.families;
  for (std::size_t i = 0; i < families.size(); ++i) {
    if (families[i].test != TestType::Welch) continue;
    problems.warn(
        "$.analysis.families[" + std::to_string(i) + "].test",
        message("pooled_answers"),
        message("pooled_answers.fix"));
  }
}

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
    return base::contains(score.items, item) || base::contains(score.weightsFrom, item);
  });
}

/// Whether the answers to @p item are numbers or choices that a family could compare. Choices among
/// alternatives are votes and do not count.
bool isCountable(const Item& item) {
  return questionnaires::answerKindOf(item.type) != questionnaires::AnswerKind::Text &&
         item.optionSource == questionnaires::OptionSource::Listed && item.consentOption.empty() &&
         !item.isIdentifying;
}

/// The ids of items with countable answers that no family, score or threshold uses: "ease, effort".
std::string unusedItems(const Protocol& protocol, const Instrument& instrument) {
  std::string ids;
  for (const auto& item : instrument.items) {
    const bool isUsed = !isCountable(item) || item.acceptableFrom ||
                        isScored(instrument, item.id) || isCompared(protocol, instrument, item);
    if (!isUsed) ids += (ids.empty() ? "" : ", ") + item.id;
  }
  return ids;
}

}  // namespace

void addItemWarnings(const LoadedProtocol& loaded, questionnaires::Problems& problems) {
  const auto& protocol = loaded.protocol;
  if (protocol.analysis.families.empty()) return;  // addAnalysisWarnings() reports missing families
  std::set<std::string> reportedInstruments;
  bool isBeforeFirstBlock = true;  // forms before the first block are about the participant
  for (const auto& use : instrumentUses(protocol)) {
    if (use.phase == PhaseType::Block) isBeforeFirstBlock = false;
    if (isBeforeFirstBlock || !reportedInstruments.insert(use.instrument).second) continue;
    const auto ids = unusedItems(protocol, *loaded.instrument(use.instrument));
    if (ids.empty()) continue;
    problems.warn(
        use.path,
        message("items_not_analysed", use.instrument, ids),
        message("items_not_analysed.fix"));
  }
}

}  // namespace protocols
