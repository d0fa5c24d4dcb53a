#pragma once

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "base/embedded_file.h"
#include "protocols/model/loaded_protocol.h"
#include "questionnaires/json/problem.h"
#include "questionnaires/reading/instrument_file.h"

namespace protocols {

/// The files of protocols/library.
std::span<const base::EmbeddedFile> libraryFiles();

/// Reads a protocol and everything it refers to, and checks its consistency. std::nullopt if there
/// are errors; warnings do not prevent its use.
std::optional<LoadedProtocol> loadProtocol(
    std::string_view json,
    const FileFinder& find,
    questionnaires::Problems& problems,
    Defaults defaults = Defaults::Current);

/// Like loadProtocol() above, from the copies that a study stores: of all files, and of the
/// library's instruments, which replace those of the program.
std::optional<LoadedProtocol> loadProtocol(
    std::string_view json,
    const std::vector<SourceFile>& files,
    questionnaires::Problems& problems,
    Defaults defaults = Defaults::Current);

/// Loads a protocol from a file, or from the library by name ("punch-face-validity"). Referenced
/// files are searched for in the folder of the file.
/// @throws UserError  if the file cannot be read at all.
std::optional<LoadedProtocol> loadProtocolFile(
    const std::string& path, questionnaires::Problems& problems);

/// A copy of @p loaded with its "texts" replaced by @p texts. std::nullopt and problems if a text
/// cannot be used.
std::optional<LoadedProtocol> withTexts(
    const LoadedProtocol& loaded,
    const questionnaires::BlankTexts& texts,
    questionnaires::Problems& problems);

}  // namespace protocols
