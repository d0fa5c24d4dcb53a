// Runs the punch's models on the emulated board and prints their results: Report.
#include "haptics/firmware/board.h"
#include "haptics/firmware/report.h"

using namespace haptics::firmware;

int main() {
  Report report(
      [](const char* name, int step, uint32_t bits) {
        board::print(name);
        board::print(" ");
        board::printNumber(static_cast<uint32_t>(step), false);
        board::print(" ");
        board::printNumber(bits, true);
        board::print("\n");
      },
      [] { board::startCounting(); },
      [] { return board::instructions(); });
  report.run();
  board::print("stack 0 ");
  board::printNumber(board::stackUsed(), true);
  board::print("\n");
  return 0;
}
