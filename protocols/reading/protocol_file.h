#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "protocols/model/loaded_protocol.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// A protocol that may have errors, with all parts and files that were readable.
///
/// An unreadable part is empty, and its problem has been reported. Validation reports nothing about
/// such a part, or about names that may refer to it. So all errors of a file are reported at once,
/// without errors that are only consequences.
struct UnvalidatedProtocol {
  LoadedProtocol loaded;
  bool hasAllInstruments = true;  ///< whether all files of 'instrument_files' were readable

  /// Whether @p id is a valid id, all devices were readable, and none has this id.
  bool lacksDevice(std::string_view id) const noexcept;
  bool lacksCondition(std::string_view id) const noexcept;
  bool lacksInstrument(std::string_view id) const noexcept;

  /// Whether id and type of every phase were readable.
  bool hasAllPhases() const noexcept;
};

/// Reads a protocol and all files that it refers to (docs/protocol-format.md). A part that cannot
/// be read is empty and gets a problem. std::nullopt only if @p json is not a JSON object, or is a
/// file of another format. Consistency is checked by validate().
/// @param copies  finds copies of the library's instruments; if empty, the program's own
///     instruments are read.
std::optional<UnvalidatedProtocol> readUnvalidatedProtocol(
    std::string_view json,
    const FileFinder& find,
    questionnaires::Problems& problems,
    Defaults defaults = Defaults::Current,
    const FileFinder& copies = {});

/// Returns @p json with @p texts as the value of "texts", or without this key if @p texts is empty.
/// The rest of the file, including line breaks and spaces, is unchanged.
/// @pre @p json is a valid JSON object.
std::string withTexts(
    std::string_view json, const std::map<std::string, questionnaires::LocalizedText>& texts);

/// Returns @p json with another id and title of the study, so that it is a protocol of its own. The
/// rest of the file, including line breaks and spaces, is unchanged.
/// @pre @p json is a valid JSON object that readUnvalidatedProtocol() could read.
std::string withName(std::string_view json, const std::string& id, const std::string& title);

}  // namespace protocols
