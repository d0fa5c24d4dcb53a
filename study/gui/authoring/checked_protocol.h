#pragma once

#include <optional>
#include <string>
#include <vector>

#include "protocols/model/loaded_protocol.h"

namespace study::gui {

/// A protocol file as read from disk, with all problems found in it.
struct CheckedProtocol {
  std::string source;                               ///< a path, or the name of a built-in protocol
  std::string text;                                 ///< empty if the file cannot be read
  std::optional<protocols::LoadedProtocol> loaded;  ///< std::nullopt if there are errors
  std::vector<questionnaires::Problem> problems;

  int errors() const noexcept;
  int warnings() const noexcept;
  /// The last line of `palpate protocol check`: the protocol is valid, or cannot be used yet.
  std::string verdict() const;
};

/// Reads and checks a protocol as `palpate protocol check` does. An unreadable file is reported as
/// a problem.
CheckedProtocol checkProtocol(const std::string& source);

/// The names of the built-in protocols.
std::vector<std::string> shippedProtocols();

}  // namespace study::gui
