// palpate-bench: measures Palpate itself. Studies do not need it.
#include <CLI/CLI.hpp>

#include "study/app/run_program.h"
#include "study/bench/bench_program.h"

int main(int argc, char** argv) {
  study::app::Action action;
  const auto program = study::bench::makeBenchProgram(action);
  return study::app::runProgram(*program, action, argc, argv);
}
