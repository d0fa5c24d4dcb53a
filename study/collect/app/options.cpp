#include "study/collect/app/options.h"

#include <cstdlib>

#include <CLI/CLI.hpp>

namespace study::collect {
namespace {

constexpr const char* kAccountVariable = "PALPATE_STATION";

}  // namespace

CLI::Option* addServerOption(CLI::App& command, std::string& server) {
  return command
      .add_option(
          "--server",
          server,
          "PostgreSQL server: \"service=NAME\" or \"host=… dbname=…\" (default: the variables "
          "PGHOST, PGDATABASE, …)")
      ->type_name("WHERE")
      ->envname("PALPATE_SERVER");
}

Connection connectionTo(const std::string& server, const std::string& advice) {
  try {
    return Connection(server);
  } catch (const ServerError& error) {
    if (!server.empty()) throw;
    throw ServerError(
        error.kind(),
        std::string(error.what()) +
            "\nNeither --server nor the variable PALPATE_SERVER says where the server is." +
            advice);
  }
}

// NOLINTBEGIN(concurrency-mt-unsafe): the program has one thread
StationFolderOverride::StationFolderOverride(const std::filesystem::path& folder) {
  if (const char* before = std::getenv(kAccountVariable)) before_ = before;
  setenv(kAccountVariable, folder.c_str(), 1);
}

StationFolderOverride::~StationFolderOverride() {
  if (before_) {
    setenv(kAccountVariable, before_->c_str(), 1);
  } else {
    unsetenv(kAccountVariable);
  }
}
// NOLINTEND(concurrency-mt-unsafe)

}  // namespace study::collect
