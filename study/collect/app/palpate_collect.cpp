// palpate-collect: the only program that speaks to PostgreSQL.
#include <CLI/CLI.hpp>

#include "study/app/run_program.h"
#include "study/collect/app/collect_program.h"

int main(int argc, char** argv) {
  study::collect::Action action;
  const auto program = study::collect::makeCollectProgram(action);
  return study::app::runProgram(*program, action, argc, argv);
}
