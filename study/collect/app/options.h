#pragma once

#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace study::collect {

/// --server, with a default from the environment variable PALPATE_SERVER.
CLI::Option* addServerOption(CLI::App& command, std::string& server);

}  // namespace study::collect
