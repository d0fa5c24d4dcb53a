#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "base/search.h"
#include "protocols/changed_meaning.h"
#include "protocols/model/messages.h"
#include "protocols/orders/schedule.h"
#include "questionnaires/scoring/scoring.h"

namespace protocols {
namespace {

using Aspect = ChangedMeaning::Aspect;
using Json = nlohmann::json;  // sorts members
using questionnaires::Instrument;
using questionnaires::Item;
using questionnaires::Score;

/// Whether a text differs in a language that both versions have.
bool isReworded(const LocalizedText& before, const LocalizedText& after) {
  const auto& texts = before.all();
  return before.isEmpty() != after.isEmpty() || std::ranges::any_of(texts, [&](const auto& text) {
           return after.has(text.first) && after.in(text.first) != text.second;
         });
}

bool isReworded(const Item& before, const Item& after) {
  const auto& labels = before.scale.pointLabels;
  return isReworded(before.text, after.text) || isReworded(before.leftText, after.leftText) ||
         isReworded(before.rightText, after.rightText) ||
         isReworded(before.scale.lowLabel, after.scale.lowLabel) ||
         isReworded(before.scale.highLabel, after.scale.highLabel) ||
         !std::ranges::equal(
             labels,
             after.scale.pointLabels,
             [](const auto& one, const auto& other) { return !isReworded(one, other); }) ||
         !std::ranges::equal(before.options, after.options, [](const auto& one, const auto& other) {
           return one.id == other.id && !isReworded(one.text, other.text);
         });
}

bool isScoredAlike(Score before, const Score& after) {
  before.title = after.title;
  return before == after;
}

/// Whether an item is asked about a condition in a block; std::nullopt if that block does not ask
/// about the condition with this instrument.
std::optional<bool> isAsked(
    const LoadedProtocol& in,
    const std::string& block,
    const std::string& condition,
    const Instrument& instrument,
    const std::string& item) {
  const auto* phase = in.protocol.phase(block);
  if (phase == nullptr || !base::contains(phase->trials.conditions, condition)) return {};
  for (const auto& asked : phase->trials.questionnaires) {
    if (asked.instrument != instrument.id) continue;
    return base::withId(instrument.itemsOf(asked.itemSetFor(condition)), item) != nullptr;
  }
  return {};
}

/// The entry of @p list with this id, or its member @p key; null if there is none.
Json entryIn(
    const Json& protocol, const char* list, const std::string& id, const char* key = nullptr) {
  for (const auto& entry : protocol.at(list)) {
    if (entry.at("id") == id) return key == nullptr ? entry : entry.value(key, Json());
  }
  return {};
}

/// All that determines what is felt as a condition: its scene, its device, the files that they
/// name, and the files that these name.
std::string sceneOf(const LoadedProtocol& loaded, const Condition& condition) {
  const auto protocol = Json::parse(loaded.text, nullptr, false);
  if (protocol.is_discarded()) return {};
  auto all = entryIn(protocol, "conditions", condition.id, "scene").dump();
  all += entryIn(protocol, "devices", condition.device).dump();
  if (loaded.defaults == Defaults::Release01) all += "defaults of 0.1";
  std::vector<bool> isAdded(loaded.files.size());
  for (std::size_t i = 0; i < loaded.files.size();) {
    const auto& file = loaded.files[i];
    if (isAdded[i] || all.find(Json(file.name).dump()) == std::string::npos) {
      ++i;
      continue;
    }
    all += file.text;
    isAdded[i] = true;
    i = 0;  // it may name files that come before it
  }
  return all;
}

/// Collects the changes from one version to another.
class VersionComparison {
 public:
  VersionComparison(const LoadedProtocol& before, const LoadedProtocol& after)
      : before_(before), after_(after) {}

  std::vector<ChangedMeaning> all() {
    for (const auto& instrument : after_.instruments) {
      if (const auto* earlier = before_.instrument(instrument.id)) compare(*earlier, instrument);
    }
    for (const auto& condition : after_.protocol.conditions) {
      const auto* earlier = before_.protocol.condition(condition.id);
      if (earlier == nullptr) continue;
      note(sceneOf(before_, *earlier) != sceneOf(after_, condition), Aspect::Scene, condition.id);
      note(earlier->title != condition.title, Aspect::Title, condition.id);
    }
    for (const auto& block : blocksOrderedOtherwise(before_.protocol, after_.protocol)) {
      note(true, Aspect::Order, block);
    }
    std::ranges::sort(changes_);
    return std::move(changes_);
  }

 private:
  void note(
      bool differs, Aspect aspect, const std::string& id, const std::string& instrument = {}) {
    if (differs) changes_.push_back({aspect, instrument, id});
  }

  void compare(const Instrument& before, const Instrument& after) {
    for (const auto& item : after.items) {
      const auto* earlier = before.item(item.id);
      if (earlier == nullptr) {
        note(scaleOf(item).has_value(), Aspect::Asked, item.id, after.id);
        continue;
      }
      note(!haveSameScale(*earlier, item), Aspect::Scale, item.id, after.id);
      note(earlier->key != item.key, Aspect::Key, item.id, after.id);
      note(isReworded(*earlier, item), Aspect::Wording, item.id, after.id);
      note(isAskedElsewhere(before, after, item.id), Aspect::Asked, item.id, after.id);
    }
    for (const auto& score : after.scores) {
      const auto* earlier = comparableScore(before, after, score);
      note(earlier == nullptr, Aspect::Scale, score.id, after.id);
      note(
          earlier != nullptr && !isScoredAlike(*earlier, score), Aspect::Score, score.id, after.id);
    }
  }

  bool isAskedElsewhere(
      const Instrument& before, const Instrument& after, const std::string& item) const {
    for (const auto& phase : after_.protocol.phases) {
      for (const auto& condition : phase.trials.conditions) {
        const auto earlier = isAsked(before_, phase.id, condition, before, item);
        const auto now = isAsked(after_, phase.id, condition, after, item);
        if (earlier && now && *earlier != *now) return true;
      }
    }
    return false;
  }

  const LoadedProtocol& before_;
  const LoadedProtocol& after_;
  std::vector<ChangedMeaning> changes_;
};

}  // namespace

std::vector<ChangedMeaning> changedMeaning(
    const LoadedProtocol& before, const LoadedProtocol& after) {
  return VersionComparison(before, after).all();
}

bool haveSameScale(const Item& one, const Item& other) {
  return answerKindOf(one.type) == answerKindOf(other.type) && scaleOf(one) == scaleOf(other);
}

const Score* comparableScore(const Instrument& asked, const Instrument& now, const Score& score) {
  const auto* own = asked.score(score.id);
  if (own == nullptr) return nullptr;
  const auto range = questionnaires::rangeOf(asked, *own);
  const auto rangeNow = questionnaires::rangeOf(now, score);
  const bool hasOtherRange = range.low != rangeNow.low || range.high != rangeNow.high;
  const bool hasOtherItem = std::ranges::any_of(own->items, [&](const auto& id) {
    const auto* item = asked.item(id);
    const auto* itemNow = now.item(id);
    return item != nullptr && itemNow != nullptr && !haveSameScale(*item, *itemNow);
  });
  return hasOtherRange || hasOtherItem ? nullptr : own;
}

base::Message inWords(
    Aspect aspect, std::size_t participants, std::size_t everybody, const std::string& ids) {
  switch (aspect) {
    case Aspect::Scale:
      return message("changed.scale", participants, everybody, ids);
    case Aspect::Score:
      return message("changed.score", participants, everybody, ids);
    case Aspect::Key:
      return message("changed.key", participants, everybody, ids);
    case Aspect::Wording:
      return message("changed.wording", participants, everybody, ids);
    case Aspect::Asked:
      return message("changed.asked", participants, everybody, ids);
    case Aspect::Scene:
      return message("changed.scene", participants, everybody, ids);
    case Aspect::Title:
      return message("changed.title", participants, everybody, ids);
    case Aspect::Order:
      return message("changed.order", participants, everybody, ids);
  }
  return {};
}

}  // namespace protocols
