#pragma once

#include <filesystem>
#include <optional>
#include <string>

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace study::collect {

/// --server, with a default from the environment variable PALPATE_SERVER.
CLI::Option* addServerOption(CLI::App& command, std::string& server);

/// The account of a station in a folder of its own, as long as it exists: on one computer several
/// act, or one that leaves nothing behind.
class Account {
 public:
  explicit Account(const std::filesystem::path& folder);
  ~Account();
  Account(const Account&) = delete;
  Account& operator=(const Account&) = delete;

 private:
  std::optional<std::string> before_;
};

}  // namespace study::collect
