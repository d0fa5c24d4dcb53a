#include "protocols/orders/schedule.h"

#include <algorithm>
#include <numeric>
#include <set>
#include <string>

#include "base/random.h"
#include "base/search.h"

namespace protocols {
namespace {

Row identityRow(int k) {
  Row row(static_cast<std::size_t>(k));
  std::iota(row.begin(), row.end(), 0);
  return row;
}

Row shifted(const Row& row, int by) {
  Row result;
  for (const int value : row) result.push_back((value + by) % static_cast<int>(row.size()));
  return result;
}

/// The first row of Williams' design: 0, 1, k−1, 2, k−2, …. For even k, the differences of
/// neighbours (modulo k) are all different. For odd k, this row and the reversed row together have
/// each difference twice.
Row williamsRow(int k) {
  Row row{0};
  for (int low = 1, high = k - 1; static_cast<int>(row.size()) < k;) {
    row.push_back(low++);
    if (static_cast<int>(row.size()) < k) row.push_back(high--);
  }
  return row;
}

std::vector<Row> williamsRows(int k) {
  std::vector<Row> rows;
  for (int i = 0; i < k; ++i) rows.push_back(shifted(williamsRow(k), i));
  if (k % 2 == 0) return rows;
  for (int i = 0; i < k; ++i) {
    Row mirrored = rows[static_cast<std::size_t>(i)];
    std::ranges::reverse(mirrored);
    rows.push_back(std::move(mirrored));
  }
  return rows;
}

std::vector<Row> permutations(int k) {
  std::vector<Row> rows;
  Row row = identityRow(k);
  do rows.push_back(row);
  while (std::next_permutation(row.begin(), row.end()));
  return rows;
}

}  // namespace

std::vector<Row> rowsOf(OrderType type, int k) {
  std::vector<Row> rows;
  switch (type) {
    case OrderType::Fixed:
      return {identityRow(k)};
    case OrderType::LatinSquare:
      for (int i = 0; i < k; ++i) rows.push_back(shifted(identityRow(k), i));
      return rows;
    case OrderType::BalancedLatinSquare:
      return k < 2 ? permutations(k) : williamsRows(k);
    case OrderType::Complete:
      return permutations(k);
    case OrderType::Random:
    case OrderType::Reversed:
      return {};
  }
  return {};
}

Row orderFor(
    OrderType type, int k, std::uint64_t seed, std::uint64_t slot, std::string_view purpose) {
  const auto rows = rowsOf(type, k);
  if (rows.empty()) {
    Row row = identityRow(k);
    base::RandomStream(seed, slot, "order/" + std::string(purpose)).shuffle(row);
    return row;
  }
  Row sequence = identityRow(static_cast<int>(rows.size()));
  base::RandomStream(seed, slot / rows.size(), "rows/" + std::string(purpose)).shuffle(sequence);
  return rows[static_cast<std::size_t>(sequence[slot % rows.size()])];
}

namespace {

/// The block's conditions in the order of the protocol's "conditions". Labels number conditions in
/// this order, whereas rows number them in the order of the block.
std::vector<std::string> inProtocolOrder(const Protocol& protocol, const Block& block) {
  std::vector<std::string> sorted;
  for (const auto& condition : protocol.conditions) {
    if (base::contains(block.conditions, condition.id)) sorted.push_back(condition.id);
  }
  return sorted;
}

/// The conditions of all blocks, in the order of the protocol's "conditions".
std::vector<std::string> feltConditions(const Protocol& protocol) {
  std::vector<std::string> felt;
  for (const auto& condition : protocol.conditions) {
    const bool isFelt = std::ranges::any_of(protocol.phases, [&](const Phase& phase) {
      return base::contains(phase.trials.conditions, condition.id);
    });
    if (isFelt) felt.push_back(condition.id);
  }
  return felt;
}

int indexOf(const std::vector<std::string>& all, const std::string& one) {
  return static_cast<int>(std::ranges::find(all, one) - all.begin());
}

std::vector<std::string> realisedOrder(
    const Schedule& before,
    const Phase& phase,
    std::uint64_t seed,
    const std::string& cohort,
    std::uint64_t slot) {
  const auto& block = phase.trials;
  std::vector<std::string> order;
  if (block.order.type == OrderType::Reversed) {
    const auto* other = before.block(block.order.of);
    for (const auto& trial : other->trials) order.push_back(trial.condition);
    std::ranges::reverse(order);
    return order;
  }
  const auto row = orderFor(
      block.order.type,
      static_cast<int>(block.conditions.size()),
      seed,
      slot,
      phase.id + "/" + cohort);
  for (const int index : row) order.push_back(block.conditions[static_cast<std::size_t>(index)]);
  return order;
}

/// The drawn label of each condition of @p sorted, from 1.
std::vector<int> drawnLabels(
    const std::vector<std::string>& sorted,
    std::uint64_t seed,
    const std::string& cohort,
    std::uint64_t slot) {
  std::string purpose = "labels/" + cohort;
  std::vector<int> labels;
  for (const auto& condition : sorted) {
    purpose += "/" + condition;
    labels.push_back(static_cast<int>(labels.size()) + 1);
  }
  base::RandomStream(seed, slot, purpose).shuffle(labels);
  return labels;
}

}  // namespace

const PlannedBlock* Schedule::block(std::string_view phase) const noexcept {
  const auto found = std::ranges::find_if(blocks, [&](const auto& b) { return b.phase == phase; });
  return found == blocks.end() ? nullptr : &*found;
}

Schedule scheduleFor(
    const Protocol& protocol, std::uint64_t seed, std::string_view cohort, std::uint64_t slot) {
  const std::string group(cohort);
  Schedule schedule;
  for (const auto& phase : protocol.phases) {
    if (phase.type != PhaseType::Block) continue;
    const auto sorted = inProtocolOrder(protocol, phase.trials);
    const auto drawn = drawnLabels(sorted, seed, group, slot);
    PlannedBlock block{.phase = phase.id, .trials = {}};
    for (const auto& condition : realisedOrder(schedule, phase, seed, group, slot)) {
      const int position = static_cast<int>(block.trials.size()) + 1;
      const int index = indexOf(sorted, condition);
      const int label = protocol.labels.policy == LabelPolicy::Condition ? index + 1
                        : protocol.labels.policy == LabelPolicy::Position
                            ? position
                            : drawn[static_cast<std::size_t>(index)];
      block.trials.push_back({condition, position, label});
    }
    schedule.blocks.push_back(std::move(block));
  }
  return schedule;
}

std::vector<std::string> blocksOrderedOtherwise(const Protocol& before, const Protocol& after) {
  const bool isEachDrawnOtherwise = before.seed != after.seed ||
                                    before.labels.policy != after.labels.policy ||
                                    feltConditions(before) != feltConditions(after);
  std::set<std::string> blocks;
  const auto compare = [&](const Protocol& one, const Protocol& other) {
    for (const auto& phase : one.phases) {
      const auto* same = other.phase(phase.id);
      const bool isDrawnAlike = same != nullptr && same->type == phase.type &&
                                same->trials.order.type == phase.trials.order.type &&
                                same->trials.order.of == phase.trials.order.of &&
                                same->trials.conditions == phase.trials.conditions;
      const bool isBlock = phase.type == PhaseType::Block;
      if (isBlock && (isEachDrawnOtherwise || !isDrawnAlike)) blocks.insert(phase.id);
    }
  };
  compare(before, after);
  compare(after, before);
  return {blocks.begin(), blocks.end()};
}

Balance balanceOf(
    const Protocol& protocol,
    const Phase& block,
    std::uint64_t seed,
    std::string_view cohort,
    std::size_t participants) {
  const Phase* source = &block;
  while (source->trials.order.type == OrderType::Reversed) {
    source = protocol.phase(source->trials.order.of);
  }
  const auto k = block.trials.conditions.size();
  const auto type = source->trials.order.type;
  Balance balance;
  balance.conditions = block.trials.conditions;
  balance.multipleOf = rowsOf(type, static_cast<int>(k)).size();
  balance.isBalanced =
      type != OrderType::Fixed && balance.multipleOf > 0 && participants % balance.multipleOf == 0;
  balance.positionCounts.assign(k, std::vector<int>(k, 0));
  balance.after.assign(k, std::vector<int>(k, 0));
  for (std::size_t slot = 0; slot < participants; ++slot) {
    const auto schedule = scheduleFor(protocol, seed, cohort, slot);
    int previous = -1;
    for (const auto& trial : schedule.block(block.id)->trials) {
      const int index = indexOf(balance.conditions, trial.condition);
      const auto at = static_cast<std::size_t>(index);
      ++balance.positionCounts[at][static_cast<std::size_t>(trial.position - 1)];
      if (previous >= 0) ++balance.after[at][static_cast<std::size_t>(previous)];
      previous = index;
    }
  }
  return balance;
}

}  // namespace protocols
