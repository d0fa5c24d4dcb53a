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

/// The protocols and other files of protocols/library, embedded in the program.
std::span<const base::EmbeddedFile> libraryFiles();

/// The names of the protocols in the library, such as "punch-face-validity".
std::vector<std::string> libraryProtocols();

/// The text of the protocol with this name in the library; std::nullopt if there is none.
std::optional<std::string_view> libraryProtocol(std::string_view name);

/// Reads a protocol and all files that it refers to, and checks their consistency. std::nullopt if
/// there are errors; warnings do not prevent its use.
std::optional<LoadedProtocol> loadProtocol(
    std::string_view json,
    const FileFinder& find,
    questionnaires::Problems& problems,
    Defaults defaults = Defaults::Current);

/// Like loadProtocol() above, but reads the files from the copies that a study stores. Copies of
/// the library's instruments replace those of the program.
std::optional<LoadedProtocol> loadProtocol(
    std::string_view json,
    const std::vector<SourceFile>& files,
    questionnaires::Problems& problems,
    Defaults defaults = Defaults::Current);

/// Loads a protocol from a file, or from the library by name ("punch-face-validity"). Files that
/// the protocol refers to are searched for in its folder.
/// @throws UserError  if the file cannot be read at all.
std::optional<LoadedProtocol> loadProtocolFile(
    const std::string& path, questionnaires::Problems& problems);

/// A copy of @p loaded with @p texts as its "texts". If a text cannot be used, adds problems and
/// returns std::nullopt.
std::optional<LoadedProtocol> withTexts(
    const LoadedProtocol& loaded,
    const questionnaires::BlankTexts& texts,
    questionnaires::Problems& problems);

/// The texts of @p before for the blanks that @p changed, a later version of it, leaves empty.
questionnaires::BlankTexts keptTexts(const LoadedProtocol& before, const LoadedProtocol& changed);

/// A copy of @p changed with keptTexts().
LoadedProtocol withKeptTexts(const LoadedProtocol& before, const LoadedProtocol& changed);

}  // namespace protocols
