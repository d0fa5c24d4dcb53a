#include "protocols/block_rules.h"

#include <algorithm>
#include <set>
#include <string>

#include "protocols/order.h"

namespace protocols {
namespace {

using questionnaires::Problems;

std::set<std::string> asSet(const std::vector<std::string>& names) {
  return {names.begin(), names.end()};
}

/// Looks at one block of a protocol.
class BlockCheck {
 public:
  BlockCheck(const LoadedProtocol& loaded, std::size_t index, Problems& problems)
      : loaded_(loaded),
        protocol_(loaded.protocol),
        phase_(loaded.protocol.phases[index]),
        block_(phase_.trials),
        path_("$.phases[" + std::to_string(index) + "]"),
        problems_(problems) {}

  void all() {
    conditions();
    order();
    for (std::size_t i = 0; i < block_.questionnaires.size(); ++i) questionnaire(i);
    if (!problems_.hasErrors()) balance();
  }

 private:
  void conditions() {
    for (std::size_t i = 0; i < block_.conditions.size(); ++i) {
      if (protocol_.condition(block_.conditions[i]) != nullptr) continue;
      problems_.add(
          path_ + ".conditions[" + std::to_string(i) + "]",
          "there is no condition '" + block_.conditions[i] + "'",
          "add it to 'conditions', or correct the name");
    }
  }

  void order() {
    const auto type = block_.order.type;
    if (type == OrderType::Complete && block_.conditions.size() > std::size_t{kMostForComplete}) {
      problems_.add(
          path_ + ".order",
          "all orders of " + std::to_string(block_.conditions.size()) + " conditions are too many",
          "use balancedLatinSquare");
    }
    if (type == OrderType::Reversed) reversed();
  }

  void reversed() {
    const auto* other = protocol_.phase(block_.order.of);
    if (other == nullptr || other->type != PhaseType::Block) {
      problems_.add(
          path_ + ".order.of",
          "there is no block '" + block_.order.of + "'",
          "name a block before this one");
      return;
    }
    if (isInACircle()) {
      problems_.add(
          path_ + ".order.of",
          "the orders of these blocks refer to each other in a circle",
          "let one of them have an order of its own");
    } else if (other >= &phase_) {
      problems_.add(
          path_ + ".order.of",
          "'" + block_.order.of + "' does not come before this block",
          "reverse the order of a block before this one");
    }
    if (asSet(other->trials.conditions) != asSet(block_.conditions)) {
      problems_.add(
          path_ + ".conditions",
          "not the conditions of '" + block_.order.of + "', whose order is reversed",
          "list the same conditions");
    }
  }

  bool isInACircle() const {
    std::set<const Phase*> seen;
    const Phase* phase = &phase_;
    while (phase != nullptr && phase->trials.order.type == OrderType::Reversed) {
      if (!seen.insert(phase).second) return true;
      phase = protocol_.phase(phase->trials.order.of);
    }
    return false;
  }

  void questionnaire(std::size_t index) {
    const auto& asked = block_.questionnaires[index];
    const std::string path = path_ + ".questionnaires[" + std::to_string(index) + "]";
    const auto* instrument = loaded_.instrument(asked.instrument);
    if (instrument == nullptr) {
      problems_.add(
          path + ".instrument",
          "there is no instrument '" + asked.instrument + "'",
          "name one of the library, or list its file in 'instrument_files'");
      return;
    }
    for (const auto& [condition, set] : asked.setByCondition) {
      const std::string where = path + ".set_by_condition." + condition;
      const auto& mine = block_.conditions;
      if (std::find(mine.begin(), mine.end(), condition) == mine.end()) {
        problems_.add(where, "this block has no condition '" + condition + "'", "correct the name");
      }
      if (instrument->itemsOf(set).empty()) {
        problems_.add(
            where,
            "'" + asked.instrument + "' has no items of the set '" + set + "'",
            "correct the name");
      }
    }
    if (!problems_.hasErrors()) relativeItems(asked, *instrument, path);
  }

  /// A statement like "than the previous cut" needs a previous cut.
  void relativeItems(
      const ConditionQuestionnaire& asked,
      const questionnaires::Instrument& instrument,
      const std::string& path) {
    for (const auto& condition : block_.conditions) {
      if (!canComeFirst(condition)) continue;
      for (const auto& item : instrument.itemsOf(asked.setFor(condition))) {
        if (item.reference != questionnaires::Reference::Previous) continue;
        problems_.warn(
            path,
            "item '" + item.id + "' compares with the previous, and '" + condition +
                "' can come first in this block, where there is none",
            "use an order in which it cannot, or a statement that compares with nothing");
      }
    }
  }

  bool canComeFirst(const std::string& condition) const {
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

  void balance() {
    const auto k = block_.conditions.size();
    const auto type = block_.order.type;
    if (type == OrderType::Fixed && k > 1) {
      problems_.warn(
          path_ + ".order",
          "everybody feels this block in the same order",
          "what comes first or last may be preferred for that alone; 'balancedLatinSquare' avoids "
          "it");
    }
    if (type == OrderType::Fixed || type == OrderType::Random || type == OrderType::Reversed)
      return;
    const auto rows = rowsOf(type, static_cast<int>(k)).size();
    for (const auto& cohort : protocol_.cohorts) {
      if (cohort.planned == 0 || static_cast<std::size_t>(cohort.planned) % rows == 0) continue;
      problems_.warn(
          path_ + ".order",
          std::to_string(cohort.planned) + " participants of '" + cohort.id +
              "' do not balance this design",
          "plan a multiple of " + std::to_string(rows));
    }
  }

  const LoadedProtocol& loaded_;
  const Protocol& protocol_;
  const Phase& phase_;
  const Block& block_;
  std::string path_;
  Problems& problems_;
};

void checkPreference(const Protocol& protocol, std::size_t index, Problems& problems) {
  const auto& phase = protocol.phases[index];
  const auto* block = protocol.phase(phase.block);
  const std::string path = "$.phases[" + std::to_string(index) + "].block";
  if (block == nullptr || block->type != PhaseType::Block) {
    problems.add(
        path, "there is no block '" + phase.block + "'", "name the block that was just felt");
  } else if (block >= &phase) {
    problems.add(
        path,
        "the alternatives of '" + phase.block + "' have not been felt yet",
        "ask after that block");
  } else if (block->trials.conditions.size() < 2) {
    problems.add(
        path, "'" + phase.block + "' has one alternative only", "there is nothing to prefer");
  }
}

}  // namespace

void checkBlocks(const LoadedProtocol& loaded, Problems& problems) {
  const auto& phases = loaded.protocol.phases;
  bool hasBlock = false;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (phases[i].type == PhaseType::Block) {
      hasBlock = true;
      BlockCheck(loaded, i, problems).all();
    }
    if (phases[i].type == PhaseType::Preference) checkPreference(loaded.protocol, i, problems);
  }
  if (!hasBlock) {
    problems.add("$.phases", "nothing is felt in this study", "add a phase of type 'block'");
  }
}

}  // namespace protocols
