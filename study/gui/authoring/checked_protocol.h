#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocols/model/loaded_protocol.h"

namespace study::gui {

/// A protocol file as it is now, and everything that is to be said about it.
struct CheckedProtocol {
  std::string source;                               ///< a file, or the name of one that ships
  std::string text;                                 ///< empty where it cannot be read
  std::optional<protocols::LoadedProtocol> loaded;  ///< nothing where there are errors
  std::vector<questionnaires::Problem> problems;

  int errors() const noexcept;
  int warnings() const noexcept;
  /// What `palpate protocol check` says last: sound, or not to be used yet.
  std::string verdict() const;
};

/// Reads and checks it, as `palpate protocol check` does. A file that cannot be read is a problem.
CheckedProtocol checkProtocol(const std::string& source);

/// The names of the protocols that ship.
std::vector<std::string> shippedProtocols();

}  // namespace study::gui
