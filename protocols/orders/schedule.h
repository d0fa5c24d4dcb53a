#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/model/protocol.h"

namespace protocols {

/// An order of k conditions: the index of the condition at each position, from 0.
using Row = std::vector<int>;

/// The largest number of conditions of a block.
inline constexpr int kMostConditions = 100;
/// The largest number of conditions of a block with OrderType::Complete: 6! = 720 orders.
inline constexpr int kMostConditionsForComplete = 6;

/// The orders that a design of k conditions uses, each equally often. One row if all have the same
/// order; none if orders are drawn (Random) or taken from another block (Reversed).
///
/// BalancedLatinSquare is Williams' design: k rows for even k, 2k for odd k. For three conditions
/// that is all six orders, the same as Complete.
std::vector<Row> rowsOf(OrderType type, int k);

/// The order of participant number @p slot, counted from 0 in their cohort. The rows are shuffled
/// again for every full cycle, so that an operator cannot predict the next one and every cycle is
/// balanced.
Row orderFor(
    OrderType type, int k, std::uint64_t seed, std::uint64_t slot, std::string_view purpose);

/// A trial of a participant: condition, position and label.
struct PlannedTrial {
  std::string condition;
  int position = 0;  ///< 1 … k
  int label = 0;     ///< 1 … k: "Alternative 2"
};

struct PlannedBlock {
  std::string phase;
  std::vector<PlannedTrial> trials;
};

/// Everything in a session that differs between participants.
struct Schedule {
  std::vector<PlannedBlock> blocks;

  const PlannedBlock* block(std::string_view phase) const noexcept;
};

/// The schedule of participant number @p slot, counted from 0 in @p cohort. The same arguments give
/// the same schedule in every release; adding phases or questionnaires does not change it.
/// @param protocol  without errors.
Schedule scheduleFor(
    const Protocol& protocol, std::uint64_t seed, std::string_view cohort, std::uint64_t slot);

/// The counts of positions and successions if @p participants of every cohort take part.
struct Balance {
  /// The design is balanced for every multiple of this number of participants; 0 for drawn orders,
  /// which are never exactly balanced.
  std::size_t multipleOf = 1;
  bool isBalanced = false;  ///< with the given number of participants
  std::vector<std::string> conditions;
  std::vector<std::vector<int>> atPosition;  ///< [condition][position]
  std::vector<std::vector<int>> after;       ///< [condition][the condition before it]
};

Balance balanceOf(
    const Protocol& protocol,
    const Phase& block,
    std::uint64_t seed,
    std::string_view cohort,
    std::size_t participants);

}  // namespace protocols
