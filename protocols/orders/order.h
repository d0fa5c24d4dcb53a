#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "protocols/model/protocol.h"

namespace protocols {

/// An order of k things: which comes at each position, counted from 0.
using Row = std::vector<int>;

/// Most conditions of a block …
inline constexpr int kMostConditions = 100;
/// … and of a `complete` one: 6! = 720 orders.
inline constexpr int kMostForComplete = 6;

/// The orders that a design of k conditions uses, each equally often. One row where everybody has
/// the same order; none where orders are drawn (Random) or taken from elsewhere (Reversed).
///
/// BalancedLatinSquare is Williams' design: k rows for even k, 2k for odd k. For three conditions
/// that is all six orders, the same as Complete.
std::vector<Row> rowsOf(OrderType type, int k);

/// The order of participant number @p slot, counted from 0 in their cohort. Rows follow each other
/// in a sequence drawn anew for every full cycle, so that no operator can foretell the next and
/// every cycle is balanced.
Row orderFor(
    OrderType type, int k, std::uint64_t seed, std::uint64_t slot, std::string_view purpose);

}  // namespace protocols
