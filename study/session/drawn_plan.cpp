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

// What may change parts is decided here alone and must stay as it is: sessions were drawn by it.

/// Conditions that are felt in the same blocks, by these blocks.
std::map<std::set<std::string>, std::vector<std::string>> conditionsByBlocks(
    const Protocol& protocol) {
  std::map<std::set<std::string>, std::vector<std::string>> groups;
  for (const auto& condition : protocol.conditions) {
    std::set<std::string> blocks;
    for (const auto& phase : protocol.phases) {
      const auto& felt = phase.trials.conditions;
      const bool isFelt = std::find(felt.begin(), felt.end(), condition.id) != felt.end();
      if (phase.type == protocols::PhaseType::Block && isFelt) blocks.insert(phase.id);
    }
    groups[blocks].push_back(condition.id);
  }
  return groups;
}

bool hasFixedOrder(const Protocol& protocol, const std::set<std::string>& blocks) {
  return std::any_of(blocks.begin(), blocks.end(), [&](const std::string& block) {
    return protocol.phase(block)->trials.order.type == protocols::OrderType::Fixed;
  });
}

/// Which condition takes the part of which.
std::map<std::string, std::string> exchanged(
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

/// Each station draws from a seed of its own, and is balanced by itself. Without one it is the
/// study's: a study of one machine draws as before there were stations.
std::uint64_t seedAt(const std::string& station, std::uint64_t seed) {
  if (station.empty()) return seed;
  storage::Hasher hasher;
  hasher.add("orders of a station");
  hasher.add(std::to_string(seed));
  hasher.add(station);
  const auto hash = hasher.finish();
  std::uint64_t drawn = 0;
  for (std::size_t i = 0; i < sizeof drawn; ++i) {
    drawn = drawn << 8U | std::to_integer<std::uint64_t>(hash[i]);
  }
  return drawn;
}

/// A station has only its own secret. A study that was collected has the one that all are made of.
std::optional<storage::BlindingSecret> secretAt(Study& study, const storage::SessionRow& row) {
  const auto* secret = study.secretFor(row.runMode);
  if (secret == nullptr) return std::nullopt;
  return study.isCollected() && !row.station.empty() ? secret->of(row.station) : *secret;
}

}  // namespace

std::vector<Step> planWithoutConditions(Study& study, const storage::SessionRow& row) {
  const auto& protocol = study.protocol(row.protocol).protocol;
  auto steps = sessionPlan(
      protocol,
      protocols::scheduleFor(
          protocol,
          seedAt(row.station, study.seed()),
          row.cohort,
          static_cast<std::uint64_t>(row.slot)));
  for (auto& step : steps) {
    step.condition.clear();
    step.itemSet.clear();
  }
  return steps;
}

std::vector<Step> drawnPlan(Study& study, const storage::SessionRow& row) {
  const auto& protocol = study.protocol(row.protocol).protocol;
  auto schedule = protocols::scheduleFor(
      protocol,
      seedAt(row.station, study.seed()),
      row.cohort,
      static_cast<std::uint64_t>(row.slot));
  const auto secret = secretAt(study, row);
  if (!secret) return sessionPlan(protocol, schedule);
  const auto parts = exchanged(protocol, *secret, row.runMode);
  for (auto& block : schedule.blocks) {
    for (auto& trial : block.trials) {
      const auto part = parts.find(trial.condition);
      if (part != parts.end()) trial.condition = part->second;
    }
  }
  return sessionPlan(protocol, schedule);
}

}  // namespace study
