#include <algorithm>
#include <string>

#include "base/search.h"
#include "protocols/validation/validation.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

using questionnaires::isValidId;
using questionnaires::ItemType;
using questionnaires::Problems;
using questionnaires::shown;

/// Checks one family of comparisons.
class FamilyCheck {
 public:
  FamilyCheck(const UnvalidatedProtocol& draft, std::size_t index, Problems& problems)
      : draft_(draft),
        protocol_(draft.loaded.protocol),
        family_(protocol_.analysis.families[index]),
        path_("$.analysis.families[" + std::to_string(index) + "]"),
        problems_(problems) {}

  void all() {
    if (isValidId(family_.instrument)) instrument();
    for (std::size_t i = 0; i < family_.blocks.size(); ++i) block(i);
    for (std::size_t i = 0; i < family_.comparisons.size(); ++i) checkComparison(i);
  }

 private:
  void instrument() {
    const bool isAsked =
        std::ranges::any_of(protocol_.phases, [&](const auto& phase) { return mayAsk(phase); });
    if (!isAsked && draft_.hasAllPhases()) {
      problems_.add(
          path_ + ".instrument",
          "no block asks '" + shown(family_.instrument) + "' after its conditions",
          "name an instrument that one asks");
      return;
    }
    const auto* asked = draft_.loaded.instrument(family_.instrument);
    if (asked == nullptr) return;
    if (family_.score.empty()) {
      checkStatements(*asked);
    } else {
      score(*asked);
    }
  }

  /// Whether @p phase asks questions of the family's instrument about its conditions; also true if
  /// it could not be read.
  bool mayAsk(const Phase& phase) const {
    const auto& asked = phase.trials.questionnaires;
    return phase.id.empty() || !isValidId(family_.instrument) ||
           std::ranges::any_of(asked, [&](const auto& questionnaire) {
             return questionnaire.instrument == family_.instrument ||
                    !isValidId(questionnaire.instrument);
           });
  }

  void checkStatements(const questionnaires::Instrument& asked) {
    for (std::size_t i = 0; i < family_.items.size(); ++i) item(asked, i);
    const auto compared = comparedItems(family_, asked.items);
    std::optional<ComparedScale> first;
    for (const auto& item : compared) {
      const auto scale = scaleOf(item);
      if (!scale) continue;  // a missing scale was reported already
      if (!first) first = scale;
      if (*scale == *first) continue;
      problems_.add(
          path_ + (family_.items.empty() ? ".instrument" : ".items"),
          (family_.items.empty() ? "the Likert items of '" : "the compared items of '") + asked.id +
              "' have different scales",
          family_.items.empty()
              ? "answers on different scales cannot be pooled; make an instrument of each scale"
              : "answers on different scales cannot be pooled; make a family of each scale");
      return;
    }
    if (compared.empty() && family_.items.empty()) {
      problems_.add(
          path_ + ".instrument",
          "'" + asked.id + "' has no Likert items to compare",
          "name one that has, or the items to compare in 'items'");
    }
  }

  /// Checks that the score exists, and that its items are all asked about every compared condition.
  void score(const questionnaires::Instrument& asked) {
    if (!isValidId(family_.score)) return;
    const auto* score = asked.score(family_.score);
    if (score == nullptr) {
      problems_.add(
          path_ + ".score",
          "'" + asked.id + "' has no score '" + shown(family_.score) + "'",
          asked.scores.empty() ? "name items in 'items' to compare" : "correct the name");
      return;
    }
    for (const auto& phase : protocol_.phases) {
      if (phase.type != PhaseType::Block || !family_.usesBlock(phase.id)) continue;
      for (const auto& questionnaire : phase.trials.questionnaires) {
        if (questionnaire.instrument == asked.id)
          checkAllItemsAsked(asked, *score, phase, questionnaire);
      }
    }
  }

  void checkAllItemsAsked(
      const questionnaires::Instrument& asked,
      const questionnaires::Score& score,
      const Phase& phase,
      const ConditionQuestionnaire& questionnaire) {
    for (const auto& condition : phase.trials.conditions) {
      const auto items = asked.itemsOf(questionnaire.itemSetFor(condition));
      const auto isAsked = [&](const std::string& id) {
        return std::ranges::count(items, id, &questionnaires::Item::id) > 0;
      };
      if (std::ranges::all_of(score.items, isAsked)) continue;
      problems_.add(
          path_ + ".score",
          "block '" + phase.id + "' does not ask all items of '" + score.id + "' about '" +
              shown(condition) + "'",
          "ask them there, or compare items");
      return;
    }
  }

  void item(const questionnaires::Instrument& asked, std::size_t index) {
    const auto& id = family_.items[index];
    const std::string path = path_ + ".items[" + std::to_string(index) + "]";
    if (!isValidId(id)) return;
    const auto* item = asked.item(id);
    if (item == nullptr) {
      problems_.add(path, "'" + asked.id + "' has no item '" + shown(id) + "'", "correct the name");
    } else if (!questionnaires::rangeOf(*item)) {
      problems_.add(
          path,
          "answers to '" + id + "' are no numbers",
          "name a likert, semantic_differential, slider or number item");
    }
  }

  void block(std::size_t index) {
    const auto& id = family_.blocks[index];
    const auto* phase = protocol_.phase(id);
    if (!isValidId(id) || (phase == nullptr && !draft_.hasAllPhases())) return;
    if (phase != nullptr && phase->type == PhaseType::Block && mayAsk(*phase)) return;
    problems_.add(
        path_ + ".blocks[" + std::to_string(index) + "]",
        "'" + shown(id) + "' is no block that asks '" + shown(family_.instrument) + "'",
        "correct the name");
  }

  void checkComparison(std::size_t index) {
    const auto& pair = family_.comparisons[index];
    const std::string path = path_ + ".comparisons[" + std::to_string(index) + "]";
    checkComparedCondition(pair.first, path + ".first");
    checkComparedCondition(pair.second, path + ".second");
    if (pair.first.empty() || pair.second.empty()) return;
    if (pair.first == pair.second) {
      problems_.add(path, "a condition is compared with itself", "name two");
      return;
    }
    const auto end = family_.comparisons.begin() + static_cast<std::ptrdiff_t>(index);
    const bool isThere = std::any_of(family_.comparisons.begin(), end, [&](const auto& other) {
      return (other.first == pair.first && other.second == pair.second) ||
             (other.first == pair.second && other.second == pair.first);
    });
    if (isThere) problems_.add(path, "this pair is compared already", "keep one of the two");
  }

  void checkComparedCondition(const std::string& condition, const std::string& path) {
    if (draft_.lacksCondition(condition)) {
      problems_.add(path, "there is no condition '" + shown(condition) + "'", "correct the name");
    } else if (isValidId(condition) && !isAskedAbout(condition)) {
      problems_.add(
          path,
          "no block of this family asks '" + shown(family_.instrument) + "' about '" +
              shown(condition) + "'",
          "compare conditions that are asked about");
    }
  }

  bool isAskedAbout(const std::string& condition) const {
    bool isAskedAtAll = false;
    for (const auto& phase : protocol_.phases) {
      if (phase.type != PhaseType::Block || !family_.usesBlock(phase.id) || !mayAsk(phase))
        continue;
      if (mayContainCondition(phase.trials, condition)) return true;
      isAskedAtAll = true;
    }
    // An unreadable phase was reported already.
    return !isAskedAtAll || !draft_.hasAllPhases();
  }

  static bool mayContainCondition(const Block& block, const std::string& condition) {
    const auto& conditions = block.conditions;
    return conditions.empty() || !std::ranges::all_of(conditions, isValidId) ||
           base::contains(conditions, condition);
  }

  const UnvalidatedProtocol& draft_;
  const Protocol& protocol_;
  const Family& family_;
  std::string path_;
  Problems& problems_;
};

}  // namespace

void validateAnalysis(const UnvalidatedProtocol& draft, Problems& problems) {
  const auto& protocol = draft.loaded.protocol;
  for (std::size_t i = 0; i < protocol.analysis.families.size(); ++i) {
    FamilyCheck(draft, i, problems).all();
  }
  for (const auto& member : protocol.simulation.realismByCondition) {
    const std::string& condition = member.first;
    if (isValidId(condition) && !draft.lacksCondition(condition)) continue;
    problems.add(
        "$.simulation.realism." + shown(condition),
        "there is no condition '" + shown(condition) + "'",
        "correct the name");
  }
}

}  // namespace protocols
