#include "study/collect/app/options.h"

#include <CLI/CLI.hpp>

namespace study::collect {

CLI::Option* addServerOption(CLI::App& command, std::string& server) {
  return command
      .add_option(
          "--server",
          server,
          "Where PostgreSQL is: \"service=NAME\", \"host=… dbname=…\" (default: libpq's own)")
      ->type_name("WHERE")
      ->envname("PALPATE_SERVER");
}

}  // namespace study::collect
