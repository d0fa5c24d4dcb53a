// write_reference: writes the manual pages and bash completions of all programs for the package.
// Used by the build only; it is not installed.
#include <cstdio>
#include <exception>
#include <fstream>
#include <string>

#include <CLI/CLI.hpp>

#include "study/app/command_reference.h"
#include "study/app/program.h"
#include "study/app/studio_options.h"
#include "study/bench/bench_program.h"
#ifdef PALPATE_HAS_COLLECT
#include "study/collect/app/collect_program.h"
#endif
#include "study/session/study.h"

namespace {

using study::app::CommandDescription;
using study::app::ManPageSections;

/// @throws std::ios_base::failure if the file cannot be written.
void write(const std::string& path, const std::string& text) {
  std::ofstream file;
  file.exceptions(std::ios::failbit | std::ios::badbit);
  file.open(path, std::ios::binary | std::ios::trunc);
  file << text;
  file.close();
}

const std::string& versionLine() {
  static const std::string line = "palpate " + std::string(study::appVersion());
  return line;
}

ManPageSections sectionsOfPalpate() {
  return {
      .version = versionLine(),
      .summary = "face-validity studies of haptic surgical simulators",
      .exitStatus =
          "0: done. 1: it could not be done, or a check found something; standard error "
          "says why. 2: the command line is wrong.",
      .files =
          "/usr/share/palpate/protocols and /usr/share/palpate/questionnaires hold the "
          "protocols and questionnaires that ship, to be copied and changed. "
          "The manual is in /usr/share/doc/palpate. A study is a folder of its own with "
          "study.db in it; devices.json there names the laboratory's devices.",
      .seeAlso = {
          "palpate-bench(1)",
#ifdef PALPATE_HAS_COLLECT
          "palpate-collect(1)",
#endif
          "palpate-studio(1)"}};
}

ManPageSections sectionsOfBench() {
  return {
      .version = versionLine(),
      .summary = "benchmarks of Palpate: errors, stability, punctuality, speed",
      .exitStatus =
          "0: done. 1: an error or a count exceeds its bound, or it could not be measured; "
          "standard error says why. 2: the command line is wrong.",
      .files = "/usr/share/doc/palpate/benchmarks.md explains what each command measures.",
      .seeAlso = {"palpate(1)"}};
}

#ifdef PALPATE_HAS_COLLECT
ManPageSections sectionsOfCollect() {
  return {
      .version = versionLine(),
      .summary = "one study of Palpate at many sites, collected in PostgreSQL",
      .exitStatus =
          "0: done. 1: it could not be done, or a check found something; standard error "
          "says why. 2: the command line is wrong.",
      .files =
          "/usr/share/doc/palpate/collecting.md begins with ten commands. Passwords are taken "
          "from ~/.pgpass, certificates from ~/.postgresql, as psql(1) does.",
      .seeAlso = {"palpate(1)", "psql(1)"}};
}

/// Describes palpate-collect under the name of its executable; 'palpate collect' starts the same
/// program.
CommandDescription describeCollect() {
  study::app::Action action;
  const auto program = study::collect::makeCollectProgram(action);
  program->name("palpate-collect");
  return study::app::describe(*program);
}
#endif

ManPageSections sectionsOfStudio() {
  return {
      .version = versionLine(),
      .summary = "windows for running and evaluating a study of Palpate",
      .exitStatus = "0: closed, or done. 1: it could not be done; standard error says why.",
      .files = "The list of recent studies and the theme are in ~/.config/palpate/studio.ini.",
      .seeAlso = {"palpate(1)"}};
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2) {
    std::fputs("usage: write_reference FOLDER\n", stderr);
    return 2;
  }
  try {
    const std::string folder = argv[1];
    study::app::Action action;
    const auto describe = [&](const auto& program, const ManPageSections& sections) {
      write(folder + "/" + program.name + ".1", study::app::manPage(program, sections));
      write(folder + "/" + program.name + ".bash", study::app::bashCompletion(program));
    };
    auto palpate = study::app::describe(*study::app::makeProgram(action));
    const auto bench = study::app::describe(*study::bench::makeBenchProgram(action));
    describe(palpate, sectionsOfPalpate());
    describe(bench, sectionsOfBench());
    study::app::addCommandsOf(bench, "bench", palpate);
#ifdef PALPATE_HAS_COLLECT
    study::app::addCommandsOf(describeCollect(), "collect", palpate);
#endif
    // Completed as if the commands of the programs that palpate starts were its own.
    write(folder + "/palpate.bash", study::app::bashCompletion(palpate));
    describe(study::app::describeStudio(), sectionsOfStudio());
#ifdef PALPATE_HAS_COLLECT
    describe(describeCollect(), sectionsOfCollect());
#endif
  } catch (const std::exception& error) {
    std::fprintf(stderr, "write_reference: %s\n", error.what());
    return 1;
  }
  return 0;
}
