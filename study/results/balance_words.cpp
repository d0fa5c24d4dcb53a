#include "study/results/balance_words.h"

#include <fmt/format.h>

#include "protocols/orders/schedule.h"
#include "study/words/counted.h"

namespace study {

std::string balanceInWords(
    const protocols::Protocol& protocol, std::size_t participants, std::uint64_t seed) {
  std::string words;
  for (const auto& phase : protocol.phases) {
    if (phase.type != protocols::PhaseType::Block) continue;
    const auto balance =
        protocols::balanceOf(protocol, phase, seed, protocol.cohorts.front().id, participants);
    words += fmt::format("\n{}: ", phase.id);
    if (balance.multipleOf == 1) {
      words += "the same order for everybody, balanced for no number of participants.\n";
    } else if (balance.multipleOf == 0) {
      words += "drawn for everybody; no number of participants balances it exactly.\n";
    } else {
      words += fmt::format(
          "{} a cohort {} it; suitable for a multiple of {}.\n",
          words::counted(participants, "participant"),
          participants == 1    ? "does NOT balance"
          : balance.isBalanced ? "balance"
                               : "do NOT balance",
          balance.multipleOf);
    }
    for (std::size_t i = 0; i < balance.conditions.size(); ++i) {
      words += fmt::format("  {:<20} at position:", balance.conditions[i]);
      for (const int count : balance.positionCounts[i]) words += fmt::format(" {:>3}", count);
      words += "   right after:";
      for (std::size_t j = 0; j < balance.conditions.size(); ++j) {
        if (j != i) words += fmt::format(" {} {}", balance.conditions[j], balance.after[i][j]);
      }
      words += "\n";
    }
  }
  return words;
}

}  // namespace study
