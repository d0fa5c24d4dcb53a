#include <set>
#include <string>

#include "base/search.h"
#include "protocols/orders/schedule.h"
#include "protocols/validation/validation.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

using questionnaires::isValidId;
using questionnaires::Problems;
using questionnaires::shown;

std::set<std::string> asSet(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

/// Checks one block of a protocol.
class BlockCheck {
 public:
  BlockCheck(const UnvalidatedProtocol& draft, std::size_t index, Problems& problems)
      : draft_(draft),
        protocol_(draft.loaded.protocol),
        phase_(protocol_.phases[index]),
        block_(phase_.trials),
        path_("$.phases[" + std::to_string(index) + "]"),
        problems_(problems) {}

  void all() {
    conditions();
    order();
    for (std::size_t i = 0; i < block_.questionnaires.size(); ++i) checkQuestionnaire(i);
  }

 private:
  void conditions() {
    for (std::size_t i = 0; i < block_.conditions.size(); ++i) {
      if (!draft_.lacksCondition(block_.conditions[i])) continue;
      problems_.add(
          path_ + ".conditions[" + std::to_string(i) + "]",
          "there is no condition '" + shown(block_.conditions[i]) + "'",
          "add it to 'conditions', or correct the name");
    }
  }

  void order() {
    const auto type = block_.order.type;
    if (type == OrderType::Complete &&
        block_.conditions.size() > std::size_t{kMostConditionsForComplete}) {
      problems_.add(
          path_ + ".order",
          "all orders of " + std::to_string(block_.conditions.size()) + " conditions are too many",
          "use balancedLatinSquare");
    }
    if (type == OrderType::Reversed && isValidId(block_.order.of)) checkReversed();
  }

  void checkReversed() {
    const auto* other = protocol_.phase(block_.order.of);
    if (other == nullptr && !draft_.hasAllPhases()) return;
    if (other == nullptr || other->type != PhaseType::Block) {
      problems_.add(
          path_ + ".order.of",
          "there is no block '" + shown(block_.order.of) + "'",
          "name a block before this one");
      return;
    }
    if (hasCyclicOrder()) {
      problems_.add(
          path_ + ".order.of",
          "the orders of these blocks refer to each other in a circle",
          "let one of them have an order of its own");
    } else if (other >= &phase_) {
      problems_.add(
          path_ + ".order.of",
          "'" + shown(block_.order.of) + "' does not come before this block",
          "reverse the order of a block before this one");
    }
    const bool areRead = !other->trials.conditions.empty() && !block_.conditions.empty();
    if (areRead && asSet(other->trials.conditions) != asSet(block_.conditions)) {
      problems_.add(
          path_ + ".conditions",
          "not the conditions of '" + shown(block_.order.of) + "', whose order is reversed",
          "list the same conditions");
    }
  }

  bool hasCyclicOrder() const {
    std::set<const Phase*> seen;
    const Phase* phase = &phase_;
    while (phase != nullptr && phase->trials.order.type == OrderType::Reversed) {
      if (!seen.insert(phase).second) return true;
      phase = protocol_.phase(phase->trials.order.of);
    }
    return false;
  }

  void checkQuestionnaire(std::size_t index) {
    const auto& asked = block_.questionnaires[index];
    const std::string path = path_ + ".questionnaires[" + std::to_string(index) + "]";
    for (std::size_t i = 0; i < index; ++i) {
      if (!isValidId(asked.instrument) || block_.questionnaires[i].instrument != asked.instrument) {
        continue;
      }
      problems_.add(
          path + ".instrument",
          "'" + shown(asked.instrument) + "' is asked twice after each condition",
          "keep one of the two");
      break;
    }
    for (const auto& [condition, set] : asked.setByCondition) {
      checkSet(asked, condition, set, path + ".set_by_condition." + shown(condition));
    }
  }

  void checkSet(
      const ConditionQuestionnaire& asked,
      const std::string& condition,
      const std::string& set,
      const std::string& path) {
    if (!block_.conditions.empty() && !base::contains(block_.conditions, condition)) {
      problems_.add(
          path, "this block has no condition '" + shown(condition) + "'", "correct the name");
    }
    const auto* instrument = draft_.loaded.instrument(asked.instrument);
    if (instrument == nullptr || !isValidId(set)) return;
    if (instrument->itemsOf(set).empty()) {
      problems_.add(
          path,
          "'" + asked.instrument + "' has no items of the set '" + set + "'",
          "correct the name");
    }
  }

  const UnvalidatedProtocol& draft_;
  const Protocol& protocol_;
  const Phase& phase_;
  const Block& block_;
  std::string path_;
  Problems& problems_;
};

void checkPreference(const UnvalidatedProtocol& draft, std::size_t index, Problems& problems) {
  const auto& protocol = draft.loaded.protocol;
  const auto& phase = protocol.phases[index];
  const auto* block = protocol.phase(phase.block);
  if (!isValidId(phase.block) || (block == nullptr && !draft.hasAllPhases())) return;
  const std::string path = "$.phases[" + std::to_string(index) + "].block";
  const std::string name = "'" + shown(phase.block) + "'";
  if (block == nullptr || block->type != PhaseType::Block) {
    problems.add(path, "there is no block " + name, "name the block that was just felt");
  } else if (block >= &phase) {
    problems.add(
        path, "the alternatives of " + name + " have not been felt yet", "ask after that block");
  } else if (block->trials.conditions.size() == 1) {
    problems.add(path, name + " has one alternative only", "there is nothing to prefer; remove it");
  }
}

}  // namespace

void validateBlocks(const UnvalidatedProtocol& draft, Problems& problems) {
  const auto& phases = draft.loaded.protocol.phases;
  bool hasBlock = false;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (phases[i].type == PhaseType::Block) {
      hasBlock = true;
      BlockCheck(draft, i, problems).all();
    }
    if (phases[i].type == PhaseType::Preference) checkPreference(draft, i, problems);
  }
  if (!hasBlock && draft.hasAllPhases()) {
    problems.add("$.phases", "nothing is felt in this study", "add a phase of type 'block'");
  }
}

}  // namespace protocols
