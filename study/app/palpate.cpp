// palpate: the command line program. All functions of Palpate are available in it.
#include <CLI/CLI.hpp>

#include "study/app/program.h"
#include "study/app/run_program.h"

int main(int argc, char** argv) {
  study::app::Action action;
  const auto program = study::app::makeProgram(action);
  return study::app::runProgram(*program, action, argc, argv);
}
