#include <algorithm>
#include <set>
#include <string>

#include "protocols/block_rules.h"

namespace protocols {
namespace {

using questionnaires::ItemType;
using questionnaires::Problems;

/// Looks at one family of comparisons.
class FamilyCheck {
 public:
  FamilyCheck(const LoadedProtocol& loaded, std::size_t index, Problems& problems)
      : loaded_(loaded),
        protocol_(loaded.protocol),
        family_(loaded.protocol.analysis.families[index]),
        path_("$.analysis.families[" + std::to_string(index) + "]"),
        problems_(problems) {}

  void all() {
    instrument();
    blocks();
    for (std::size_t i = 0; i < family_.comparisons.size(); ++i) comparison(i);
    if (!problems_.hasErrors()) itemsInCommon();
  }

 private:
  bool isAskedIn(const Phase& phase) const {
    const auto& asked = phase.trials.questionnaires;
    return std::any_of(asked.begin(), asked.end(), [&](const auto& questionnaire) {
      return questionnaire.instrument == family_.instrument;
    });
  }

  void instrument() {
    const bool isAsked =
        std::any_of(protocol_.phases.begin(), protocol_.phases.end(), [&](const auto& phase) {
          return isAskedIn(phase);
        });
    const auto* instrument = loaded_.instrument(family_.instrument);
    if (!isAsked || instrument == nullptr) {
      problems_.add(
          path_ + ".instrument",
          "no block asks '" + family_.instrument + "' after its conditions",
          "name an instrument that one asks");
      return;
    }
    std::vector<const questionnaires::Item*> statements;
    for (const auto& item : instrument->items) {
      if (item.type == ItemType::Likert) statements.push_back(&item);
    }
    if (statements.empty()) {
      problems_.add(
          path_ + ".instrument",
          "'" + family_.instrument + "' has no Likert items to compare",
          "name one that has");
    }
    for (const auto* item : statements) {
      const auto& scale = statements.front()->scale;
      if (item->scale.lowest == scale.lowest && item->scale.points == scale.points) continue;
      problems_.add(
          path_ + ".instrument",
          "the Likert items of '" + family_.instrument + "' have different scales",
          "answers on different scales cannot be pooled; compare them in families of their own");
      return;
    }
  }

  void blocks() {
    for (const auto& id : family_.blocks) {
      const auto* phase = protocol_.phase(id);
      if (phase != nullptr && phase->type == PhaseType::Block && isAskedIn(*phase)) continue;
      problems_.add(
          path_ + ".blocks",
          "'" + id + "' is no block that asks '" + family_.instrument + "'",
          "correct the name");
    }
  }

  void comparison(std::size_t index) {
    const auto& pair = family_.comparisons[index];
    const std::string path = path_ + ".comparisons[" + std::to_string(index) + "]";
    for (const auto& id : {pair.first, pair.second}) {
      if (protocol_.condition(id) != nullptr) continue;
      problems_.add(path, "there is no condition '" + id + "'", "correct the name");
    }
    if (pair.first == pair.second) {
      problems_.add(path, "a condition is compared with itself", "name two");
    }
    for (std::size_t i = 0; i < index; ++i) {
      const auto& other = family_.comparisons[i];
      const bool isSame = (other.first == pair.first && other.second == pair.second) ||
                          (other.first == pair.second && other.second == pair.first);
      if (isSame) problems_.add(path, "this pair is compared already", "keep one of the two");
    }
  }

  /// Different statements for different conditions: method and wording are confounded.
  void itemsInCommon() {
    for (const auto& phase : protocol_.phases) {
      for (const auto& asked : phase.trials.questionnaires) {
        if (asked.instrument != family_.instrument || asked.setByCondition.empty()) continue;
        problems_.warn(
            path_,
            "conditions answer different statements in '" + phase.id + "'",
            "a difference may be one of wording; the item ids also tell an analyst which is which");
        return;
      }
    }
  }

  const LoadedProtocol& loaded_;
  const Protocol& protocol_;
  const Family& family_;
  std::string path_;
  Problems& problems_;
};

}  // namespace

void checkAnalysis(const LoadedProtocol& loaded, Problems& problems) {
  const auto& families = loaded.protocol.analysis.families;
  for (std::size_t i = 0; i < families.size(); ++i) FamilyCheck(loaded, i, problems).all();
  if (families.empty()) {
    problems.warn(
        "$.analysis",
        "no family of comparisons is declared",
        "what is compared only after a look at the data is exploratory");
  }
  for (const auto& [condition, realism] : loaded.protocol.simulation.realismByCondition) {
    if (loaded.protocol.condition(condition) != nullptr) continue;
    problems.add(
        "$.simulation.realism." + condition,
        "there is no condition '" + condition + "'",
        "correct the name");
  }
}

}  // namespace protocols
