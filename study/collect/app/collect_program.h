#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace study::collect {

/// Runs a command; returns the exit status.
using Action = std::function<int()>;

/// The command line of palpate-collect, which 'palpate collect' starts. Parsing it sets @p action
/// to the command that was called. @param action  must outlive the returned object.
std::unique_ptr<CLI::App> makeCollectProgram(Action& action);

/// Runs a command of palpate that reads a study, such as {"stats", "run", "all"}. @return  its exit
/// status
/// @throws UserError  if the command does not know an option
int runPalpate(std::vector<std::string> words);

// Each function adds its commands to the program.
void addServerCommands(CLI::App& program, Action& action);   // init, ingest, revoke, set-aside
void addStationCommands(CLI::App& program, Action& action);  // key, join, push, bundle, status
void addPullCommands(CLI::App& program, Action& action);     // pull, stats, check
void addDemoCommand(CLI::App& program, Action& action);

}  // namespace study::collect
