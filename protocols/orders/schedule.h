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

/// The orders of a design of k conditions; each order is used equally often. One row if all
/// participants have the same order; empty if orders are drawn (Random) or taken from another block
/// (Reversed).
///
/// BalancedLatinSquare is Williams' design: k rows for even k, 2k rows for odd k. For three
/// conditions these are all six orders, as with Complete.
std::vector<Row> rowsOf(OrderType type, int k);

/// The order of participant number @p slot, counted from 0 in their cohort. The rows are shuffled
/// again for every full cycle through the design, so that an operator cannot predict the next order
/// and every cycle is balanced.
Row orderFor(
    OrderType type, int k, std::uint64_t seed, std::uint64_t slot, std::string_view purpose);

/// A trial of a participant: condition, position and label.
struct PlannedTrial {
  std::string condition;
  int position = 0;  ///< from 1 to k
  int label = 0;     ///< from 1 to k: 2 for "Alternative 2"
};

/// The trials of one block, in the order of a participant.
struct PlannedBlock {
  std::string phase;
  std::vector<PlannedTrial> trials;
};

/// The parts of a session that differ between participants.
struct Schedule {
  std::vector<PlannedBlock> blocks;

  const PlannedBlock* block(std::string_view phase) const noexcept;
};

/// The schedule of participant number @p slot, counted from 0 in @p cohort. The same arguments give
/// the same schedule in every release; adding phases or questionnaires does not change it.
/// @param protocol  without errors.
Schedule scheduleFor(
    const Protocol& protocol, std::uint64_t seed, std::string_view cohort, std::uint64_t slot);

/// The blocks of @p before or @p after for which both draw other orders, so that a place of one
/// says nothing about the other. If it is empty, scheduleFor() gives the same for both.
std::vector<std::string> blocksOrderedOtherwise(const Protocol& before, const Protocol& after);

/// How often conditions are at each position and follow each other, for a number of participants.
struct Balance {
  /// The design is balanced for every multiple of this number of participants; 0 for drawn orders,
  /// which are not balanced exactly; 1 for a fixed order, which is never balanced.
  std::size_t multipleOf = 1;
  bool isBalanced = false;  ///< whether it is balanced for the given number of participants
  std::vector<std::string> conditions;
  std::vector<std::vector<int>> positionCounts;  ///< counts by [condition][position]
  std::vector<std::vector<int>> after;           ///< counts by [condition][previous condition]
};

/// @param block  a phase of type Block
Balance balanceOf(
    const Protocol& protocol,
    const Phase& block,
    std::uint64_t seed,
    std::string_view cohort,
    std::size_t participants);

}  // namespace protocols
