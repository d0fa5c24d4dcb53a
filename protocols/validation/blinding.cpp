#include <map>
#include <set>

#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"

namespace protocols {
namespace {

/// Finds everything in a protocol that discloses the condition of an answer.
class BlindingCheck {
 public:
  explicit BlindingCheck(const Protocol& protocol) : protocol_(protocol) {}

  std::vector<Disclosure> all() && {
    if (protocol_.isOpenLabel) {
      return {{"$.blinding", message("blinding_open"), message("blinding_open.fix")}};
    }
    if (protocol_.seed) {
      found_.push_back({"$.seed", message("seed_tells"), message("seed_tells.fix")});
    }
    if (protocol_.labels.policy == LabelPolicy::Condition) {
      found_.push_back({"$.labels.policy", message("labels_tell"), message("labels_tell.fix")});
    }
    reportConditionsAloneInTheirBlocks();
    for (std::size_t i = 0; i < protocol_.phases.size(); ++i) {
      if (protocol_.phases[i].type == PhaseType::Block) checkBlock(i);
    }
    return std::move(found_);
  }

 private:
  /// Reports a condition if no other condition is in exactly the same blocks, because the blocks
  /// then identify it in spite of its code. Conditions that are alone in each of their blocks are
  /// not reported.
  void reportConditionsAloneInTheirBlocks() {
    std::map<std::string, std::set<std::string>> blocksOf;
    std::set<std::string> compared;
    for (const auto& phase : protocol_.phases) {
      const auto& conditions = phase.trials.conditions;
      for (const auto& condition : conditions) blocksOf[condition].insert(phase.id);
      if (conditions.size() > 1) compared.insert(conditions.begin(), conditions.end());
    }
    std::map<std::set<std::string>, int> times;
    for (const auto& [condition, blocks] : blocksOf) ++times[blocks];
    for (std::size_t i = 0; i < protocol_.conditions.size(); ++i) {
      const auto& id = protocol_.conditions[i].id;
      if (compared.count(id) == 0 || times[blocksOf[id]] > 1) continue;
      found_.push_back(
          {"$.conditions[" + std::to_string(i) + "]",
           message("blocks_tell", id),
           message("blocks_tell.fix")});
    }
  }

  void checkBlock(std::size_t index) {
    const auto& phase = protocol_.phases[index];
    if (phase.trials.conditions.size() < 2) return;
    const std::string path = "$.phases[" + std::to_string(index) + "]";
    // A reversed order discloses as much as the order that it reverses, which was reported already.
    if (phase.trials.order.type == OrderType::Fixed) {
      found_.push_back(
          {path + ".order", message("order_tells", phase.id), message("order_tells.fix")});
    }
    for (std::size_t i = 0; i < phase.trials.questionnaires.size(); ++i) {
      std::set<std::string> sets;
      for (const auto& condition : phase.trials.conditions) {
        sets.insert(phase.trials.questionnaires[i].itemSetFor(condition));
      }
      if (sets.size() < 2) continue;
      found_.push_back(
          {path + ".questionnaires[" + std::to_string(i) + "]",
           message("statements_tell", phase.id),
           message("statements_tell.fix")});
    }
  }

  const Protocol& protocol_;
  std::vector<Disclosure> found_;
};

}  // namespace

std::vector<Disclosure> disclosuresOf(const Protocol& protocol) {
  return BlindingCheck(protocol).all();
}

void addBlindingWarnings(const Protocol& protocol, questionnaires::Problems& problems) {
  for (const auto& found : disclosuresOf(protocol)) {
    problems.warn(found.path, found.what, found.fix);
  }
}

}  // namespace protocols
