#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "protocols/model/protocol.h"

namespace protocols {

/// A condition that somebody will feel, at a position, under a label.
struct PlannedTrial {
  std::string condition;
  int position = 0;  ///< 1 … k
  int label = 0;     ///< 1 … k: "Alternative 2"
};

struct PlannedBlock {
  std::string phase;
  std::vector<PlannedTrial> trials;
};

/// Everything about a session that differs between participants.
struct Schedule {
  std::vector<PlannedBlock> blocks;

  const PlannedBlock* block(std::string_view phase) const noexcept;
};

/// The schedule of participant number @p slot, counted from 0 in @p cohort. The same arguments give
/// the same schedule for ever; phases and questionnaires that are added change none.
/// @param protocol  sound.
Schedule scheduleFor(
    const Protocol& protocol, std::uint64_t seed, std::string_view cohort, std::uint64_t slot);

/// How often things happen if @p participants of every cohort take part.
struct Balance {
  std::size_t multipleOf =
      1;                    ///< balanced for every multiple of this many; 0: never exactly (drawn)
  bool isBalanced = false;  ///< with that many participants
  std::vector<std::string> conditions;
  std::vector<std::vector<int>> atPosition;  ///< [condition][position]
  std::vector<std::vector<int>> after;       ///< [condition][the one before it]
};

Balance balanceOf(
    const Protocol& protocol,
    const Phase& block,
    std::uint64_t seed,
    std::string_view cohort,
    std::size_t participants);

}  // namespace protocols
