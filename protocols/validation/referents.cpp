// Questions about what a study need not have: a benchmark, vibration, removal, forces of full size.
#include <algorithm>
#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "protocols/model/messages.h"
#include "protocols/validation/validation.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

namespace engine = haptics::engine;
using questionnaires::Item;
using questionnaires::Problems;
using questionnaires::Referent;
using questionnaires::shown;

/// What one phase asks, and where its protocol says so.
struct Asked {
  std::string instrument;
  std::string path;
  std::vector<Item> items;
};

/// Whether @p asked asks @p item about @p condition.
bool isAskedAbout(
    const ConditionQuestionnaire& asked, const Item& item, const std::string& condition) {
  const auto set = asked.setFor(condition);
  return set.empty() || item.set == set;
}

/// The items that are asked about at least one condition of a block.
std::vector<Item> itemsAsked(
    const questionnaires::Instrument& instrument,
    const ConditionQuestionnaire& asked,
    const Block& block) {
  std::vector<Item> items;
  for (const auto& item : instrument.items) {
    const auto isAsked = [&](const auto& condition) {
      return isAskedAbout(asked, item, condition);
    };
    if (std::any_of(block.conditions.begin(), block.conditions.end(), isAsked)) {
      items.push_back(item);
    }
  }
  return items;
}

std::vector<Asked> askedIn(const LoadedProtocol& loaded, std::size_t index) {
  const auto& phase = loaded.protocol.phases[index];
  const std::string path = "$.phases[" + std::to_string(index) + "]";
  std::vector<Asked> all;
  if (const auto* instrument = loaded.instrument(phase.instrument)) {
    all.push_back({instrument->id, path + ".instrument", instrument->items});
  }
  for (std::size_t i = 0; i < phase.trials.questionnaires.size(); ++i) {
    const auto& asked = phase.trials.questionnaires[i];
    const auto* instrument = loaded.instrument(asked.instrument);
    if (instrument == nullptr) continue;
    all.push_back(
        {instrument->id,
         path + ".questionnaires[" + std::to_string(i) + "].instrument",
         itemsAsked(*instrument, asked, phase.trials)});
  }
  return all;
}

/// "'1.1', '3.2'": those of @p items that are about a benchmark.
std::string aboutBenchmark(const std::vector<Item>& items) {
  std::string names;
  for (const auto& item : items) {
    if (item.refersTo != Referent::Benchmark) continue;
    names += (names.empty() ? "'" : ", '") + shown(item.id) + "'";
  }
  return names;
}

/// What @p item asks about and the scene of @p condition does not render; nothing where it does.
std::optional<base::Message> lackOf(const Condition& condition, const Item& item) {
  const auto parts = engine::partsOf(*condition.model);
  const double scale = parts.material != nullptr  ? parts.material->forceScale
                       : parts.packing != nullptr ? parts.packing->forceScale
                                                  : 1.0;
  const bool hasJitter = parts.material != nullptr && parts.material->jitter.rms > 0.0;
  const bool isRemoved = (parts.packing != nullptr && parts.packing->isRemoved) ||
                         (parts.material != nullptr && parts.material->isRemoved);
  if (item.refersTo == Referent::Vibration && !hasJitter) {
    return message("no_vibration", item.id, condition.id);
  }
  if (item.refersTo == Referent::Pace && !isRemoved) {
    return message("no_removal", item.id, condition.id);
  }
  if (item.refersTo == Referent::ForceSize && scale < 1.0) {
    return message("scaled_force", item.id, condition.id, std::lround(100.0 * scale));
  }
  return std::nullopt;
}

/// Tells of each item once, with the first condition that does not render it.
void adviseOn(
    const Protocol& protocol,
    const Block& block,
    const ConditionQuestionnaire& asked,
    const Item& item,
    const std::string& path,
    Problems& problems) {
  for (const auto& id : block.conditions) {
    if (!isAskedAbout(asked, item, id)) continue;
    const auto lack = lackOf(*protocol.condition(id), item);
    if (!lack) continue;
    problems.warn(path, *lack, message("not_rendered.fix"));
    return;
  }
}

}  // namespace

void validateBenchmarks(const Draft& draft, Problems& problems) {
  if (!draft.hasAllPhases()) return;
  const auto& phases = draft.loaded.protocol.phases;
  for (std::size_t i = 0; i < phases.size(); ++i) {
    if (phases[i].type == PhaseType::Benchmark) return;
    for (const auto& asked : askedIn(draft.loaded, i)) {
      const auto names = aboutBenchmark(asked.items);
      if (names.empty()) continue;
      problems.add(
          asked.path,
          "'" + shown(asked.instrument) + "' asks about a benchmark (" + names +
              "), and none has been cut before",
          "put a phase of type 'benchmark' before it, or ask what refers to none ('realism-cuts', "
          "'preference-cuts')");
    }
  }
}

void addReferentWarnings(const LoadedProtocol& loaded, Problems& problems) {
  const auto& protocol = loaded.protocol;
  for (std::size_t i = 0; i < protocol.phases.size(); ++i) {
    const auto& block = protocol.phases[i].trials;
    for (std::size_t q = 0; q < block.questionnaires.size(); ++q) {
      const std::string path =
          "$.phases[" + std::to_string(i) + "].questionnaires[" + std::to_string(q) + "]";
      const auto& asked = block.questionnaires[q];
      for (const auto& item : loaded.instrument(asked.instrument)->items) {
        adviseOn(protocol, block, asked, item, path, problems);
      }
    }
  }
}

}  // namespace protocols
