// R and Python at the answers of `palpate bench stats`.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "study/bench/bench_peer_scripts.h"
#include "study/bench/bench_stats.h"
#include "study/bench/bench_workers.h"

namespace study::app {
namespace {

namespace fs = std::filesystem;

/// Something that may be installed here.
struct Peer {
  const char* name;
  std::vector<std::string> programs;  ///< the first that has what it needs
  const char* script;
  const char* file;      ///< of the script
  const char* packages;  ///< of Debian, that bring it
};

void readPeerLine(const std::string& line, TableRun& run) {
  std::istringstream words(line);
  std::string what;
  words >> what >> std::ws;
  if (what == "version") std::getline(words, run.version);
  if (what == "absent") std::getline(words, run.absence);
  if (what == "seconds") {
    double seconds = 0.0;
    words >> seconds;
    run.seconds.push_back(seconds);
  }
  if (what == "row") run.rows.push_back(tableRowIn(words));
}

TableRun runPeer(const Peer& peer, const std::vector<std::string>& arguments) {
  TableRun run;
  for (const auto& program : peer.programs) {
    run = {};
    auto call = arguments;
    const auto status =
        runProgram(program, call, [&](const std::string& line) { readPeerLine(line, run); });
    if (status == 0 && run.absence.empty() && !run.rows.empty()) return run;
    if (!status || *status == 127) {
      run.absence = "there is no " + program;
    } else if (!run.absence.empty()) {
      run.absence = program + " has no " + run.absence;
    } else {
      run.absence = program + " did not come to its end (status " + std::to_string(*status) + ")";
    }
  }
  run.absence += std::string("; on Debian: apt install ") + peer.packages;
  return run;
}

}  // namespace

std::vector<TableRun> runPeers(
    const std::string& answers, const std::string& keys, const std::string& database, int times) {
  const Peer kPeers[]{
      {"R data.table",
       {"Rscript"},
       kTableInR,
       "table.R",
       "r-base-core r-cran-data.table r-cran-rsqlite"},
      {"Python pandas",
       {"python3", "/usr/bin/python3"},
       kTableInPython,
       "table.py",
       "python3-pandas python3-scipy"}};
  std::vector<TableRun> runs;
  for (const auto& peer : kPeers) {
    const auto script = (fs::path(answers).parent_path() / peer.file).string();
    std::ofstream(script) << peer.script;
    for (const std::string kind : {"csv", "database"}) {
      std::fprintf(stderr, "%s, %s, %d times\n", peer.name, kind.c_str(), times);
      const auto& file = kind == "csv" ? answers : database;
      auto run = runPeer(peer, {script, kind, file, keys, std::to_string(times)});
      run.way = std::string(peer.name) + ", from " + (kind == "csv" ? "CSV" : "the database");
      runs.push_back(std::move(run));
    }
  }
  return runs;
}

}  // namespace study::app
