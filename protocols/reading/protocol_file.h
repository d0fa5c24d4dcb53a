#pragma once

#include <optional>
#include <string_view>

#include "protocols/model/defaults.h"
#include "protocols/model/loaded_protocol.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// A protocol that may have errors: what could be read of it and of the files that it names.
///
/// What could not be read is empty here, and a problem already. Validation adds no problem about
/// it, nor about a name that may mean it: one reading finds everything that is wrong with a file,
/// and nothing that merely follows.
struct Draft {
  LoadedProtocol loaded;
  bool hasAllInstruments = true;  ///< every one of 'instrument_files' could be read

  /// Whether @p id is a name, and the name of nothing.
  bool lacksDevice(std::string_view id) const noexcept;
  bool lacksCondition(std::string_view id) const noexcept;
  bool lacksInstrument(std::string_view id) const noexcept;

  /// Whether every phase could be read, if only its id and its type.
  bool hasAllPhases() const noexcept;
};

/// A protocol as JSON says it (docs/protocol-format.md), with everything that it refers to, as far
/// as it can be read: what cannot be is empty, and a problem. Nothing only where @p json is no JSON
/// object. Whether it all fits together is asked by validate().
std::optional<Draft> readDraft(
    std::string_view json,
    const FileFinder& find,
    questionnaires::Problems& problems,
    Defaults defaults = Defaults::Current);

}  // namespace protocols
