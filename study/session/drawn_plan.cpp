#include "study/session/drawn_plan.h"

#include <algorithm>
#include <map>
#include <set>
#include <string>

#include "protocols/orders/schedule.h"
#include "study/storage/hasher.h"

namespace study {
namespace {

using protocols::Protocol;

// The rules of the permutation must never change, because the orders of existing sessions depend on
// them.

/// Groups of conditions that are rendered in the same blocks, by the ids of these blocks.
std::map<std::set<std::string>, std::vector<std::string>> conditionsByBlocks(
    const Protocol& protocol) {
  std::map<std::set<std::string>, std::vector<std::string>> groups;
  for (const auto& condition : protocol.conditions) {
    std::set<std::string> blocks;
    for (const auto& phase : protocol.phases) {
      const auto& felt = phase.trials.conditions;
      const bool isFelt = std::ranges::find(felt, condition.id) != felt.end();
      if (phase.type == protocols::PhaseType::Block && isFelt) blocks.insert(phase.id);
    }
    groups[blocks].push_back(condition.id);
  }
  return groups;
}

bool hasFixedOrder(const Protocol& protocol, const std::set<std::string>& blocks) {
  return std::ranges::any_of(blocks, [&](const std::string& block) {
    return protocol.phase(block)->trials.order.type == protocols::OrderType::Fixed;
  });
}

/// The permutation: which condition replaces each condition of the schedule that the seed draws.
/// It lacks conditions that the protocol itself fixes.
std::map<std::string, std::string> conditionPermutation(
    const Protocol& protocol, const storage::BlindingSecret& secret, RunMode mode) {
  std::map<std::string, std::string> parts;
  const bool isPromised =
      protocol.seed || protocol.labels.policy == protocols::LabelPolicy::Condition;
  if (isPromised) return parts;
  for (const auto& [blocks, conditions] : conditionsByBlocks(protocol)) {
    if (hasFixedOrder(protocol, blocks)) continue;
    auto arranged = conditions;
    secret.arrange(arranged, "orders/" + std::string(nameOf(mode)));
    for (std::size_t i = 0; i < conditions.size(); ++i) parts.emplace(conditions[i], arranged[i]);
  }
  return parts;
}

/// The secret for a session. A station has only its own secret; a collected study derives the
/// station's secret from its own.
std::optional<storage::BlindingSecret> secretOfSession(
    Study& study, const storage::SessionRow& row) {
  const auto* secret = study.secretFor(row.runMode);
  if (secret == nullptr) return std::nullopt;
  return study.isCollected() && !row.station.empty() ? secret->of(row.station) : *secret;
}

/// The seed of a station's orders, so that each station's design is balanced by itself. Without a
/// station it is the study's seed, as in releases without stations.
/// @param secret  of the station; nullptr: the seed is derived from study's seed and label alone
std::uint64_t seedOfStation(
    const std::string& station, std::uint64_t seed, const storage::BlindingSecret* secret) {
  if (station.empty()) return seed;
  storage::Hasher hasher;
  hasher.add("orders of a station");
  hasher.add(std::to_string(seed));
  hasher.add(station);
  const auto hash = secret == nullptr ? hasher.finish() : hasher.finish(secret->bytes());
  std::uint64_t drawn = 0;
  for (std::size_t i = 0; i < sizeof drawn; ++i) {
    drawn = drawn << 8U | std::to_integer<std::uint64_t>(hash[i]);
  }
  return drawn;
}

/// Whether the orders are drawn with the station's secret (kOrdersOfStation in the first event of
/// its trail). True for a collected study, whose trail does not record it for each station.
bool usesStationSecret(Study& study) {
  if (study.isCollected()) return true;
  const auto made = study.events().valuesOfMadeStudy();
  return std::ranges::any_of(
      made, [](const auto& value) { return value.first == kOrdersOfStation; });
}

/// @param derivesSeedFromSecret  whether the station's seed is derived with its secret; ignored if
///     the protocol has a "seed"
protocols::Schedule scheduleOf(
    Study& study,
    const storage::SessionRow& row,
    const std::optional<storage::BlindingSecret>& secret,
    bool derivesSeedFromSecret) {
  const auto& protocol = study.protocol(row.protocol).protocol;
  const bool isUsed = secret && derivesSeedFromSecret && !protocol.seed;
  return protocols::scheduleFor(
      protocol,
      seedOfStation(row.station, study.seed(), isUsed ? &*secret : nullptr),
      row.cohort,
      static_cast<std::uint64_t>(row.slot));
}

std::vector<Step> planOf(Study& study, const storage::SessionRow& row, bool derivesSeedFromSecret) {
  const auto& protocol = study.protocol(row.protocol).protocol;
  const auto secret = secretOfSession(study, row);
  auto schedule = scheduleOf(study, row, secret, derivesSeedFromSecret);
  if (!secret) return sessionPlan(protocol, schedule);
  const auto parts = conditionPermutation(protocol, *secret, row.runMode);
  for (auto& block : schedule.blocks) {
    for (auto& trial : block.trials) {
      const auto part = parts.find(trial.condition);
      if (part != parts.end()) trial.condition = part->second;
    }
  }
  return sessionPlan(protocol, schedule);
}

}  // namespace

std::vector<Step> planWithoutConditions(Study& study, const storage::SessionRow& row) {
  const bool canRead = !study.isSealed() || study.hasKey();
  auto steps = sessionPlan(
      study.protocol(row.protocol).protocol,
      scheduleOf(
          study,
          row,
          canRead ? secretOfSession(study, row) : std::nullopt,
          usesStationSecret(study)));
  for (auto& step : steps) {
    step.condition.clear();
    step.itemSet.clear();
  }
  return steps;
}

std::vector<Step> drawnPlan(Study& study, const storage::SessionRow& row) {
  return planOf(study, row, usesStationSecret(study));
}

std::vector<Step> planFromStudySeed(Study& study, const storage::SessionRow& row) {
  return planOf(study, row, false);
}

}  // namespace study
