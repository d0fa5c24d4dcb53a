#pragma once

#include <map>
#include <optional>
#include <string>
#include <string_view>

#include "protocols/model/loaded_protocol.h"
#include "questionnaires/json/problem.h"

namespace protocols {

/// A protocol that may have errors, with all parts and files that could be read.
///
/// A part that could not be read is empty, and its problem has been reported. Validation reports
/// nothing about such a part, or about names that may refer to it. So all errors in a file are
/// reported at once, without consequential ones.
struct Draft {
  LoadedProtocol loaded;
  bool hasAllInstruments = true;  ///< whether all files of 'instrument_files' could be read

  /// Whether @p id is a valid name for which there is no device.
  bool lacksDevice(std::string_view id) const noexcept;
  bool lacksCondition(std::string_view id) const noexcept;
  bool lacksInstrument(std::string_view id) const noexcept;

  /// Whether at least id and type of every phase could be read.
  bool hasAllPhases() const noexcept;
};

/// Reads a protocol and everything that it refers to from its JSON (docs/protocol-format.md). A
/// part that cannot be read is empty and gets a problem. std::nullopt only if @p json is not a JSON
/// object. Consistency is checked by validate().
/// @param copies  finds copies of the library's instruments; if empty, those of the program are
///     read.
std::optional<Draft> readDraft(
    std::string_view json,
    const FileFinder& find,
    questionnaires::Problems& problems,
    Defaults defaults = Defaults::Current,
    const FileFinder& copies = {});

/// Returns @p json with the value of "texts" replaced by @p texts, or without this key if @p texts
/// is empty. The rest of the file stays the same, including its line breaks and spaces.
/// @pre @p json is a valid JSON object.
std::string withTexts(
    std::string_view json, const std::map<std::string, questionnaires::LocalizedText>& texts);

/// The protocol in @p json as one of its own: with another id and title of its study. Nothing else
/// of the file changes, neither its lines nor its spaces.
/// @pre @p json is a JSON object without faults: a protocol that could be read.
std::string withName(std::string_view json, const std::string& id, const std::string& title);

}  // namespace protocols
