#pragma once

#include <filesystem>
#include <optional>
#include <string>

#include "study/collect/server/connection.h"

namespace CLI {
class App;
class Option;
}  // namespace CLI

namespace study::collect {

/// --server, with a default from the environment variable PALPATE_SERVER.
CLI::Option* addServerOption(CLI::App& command, std::string& server);

/// Connects to the server of addServerOption().
/// @param advice  added to the error where none was named and none can be reached
/// @throws ServerError
Connection connectionTo(const std::string& server, const std::string& advice = {});

/// Sets the station's own folder (PALPATE_STATION) while this object exists, so that one computer
/// can act as several stations, or as one whose data are removed afterwards.
class StationFolderOverride {
 public:
  explicit StationFolderOverride(const std::filesystem::path& folder);
  ~StationFolderOverride();
  StationFolderOverride(const StationFolderOverride&) = delete;
  StationFolderOverride& operator=(const StationFolderOverride&) = delete;

 private:
  std::optional<std::string> before_;
};

}  // namespace study::collect
