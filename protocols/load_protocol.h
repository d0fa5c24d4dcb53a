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

/// The same of what a study keeps: all files, and copies of the library's instruments, which are
/// read in place of the program's.
std::optional<LoadedProtocol> loadProtocol(
    std::string_view json,
    const std::vector<SourceFile>& files,
    questionnaires::Problems& problems,
    Defaults defaults = Defaults::Current);

/// The same from a file, or from the library by name ("punch-face-validity"). Referenced files are
/// searched for beside the file.
/// @throws UserError  if the file cannot be read at all.
std::optional<LoadedProtocol> loadProtocolFile(
    const std::string& path, questionnaires::Problems& problems);

/// @p loaded as it would be read with @p texts as its "texts", and with the same files.
/// std::nullopt and problems if a text cannot be used.
std::optional<LoadedProtocol> withTexts(
    const LoadedProtocol& loaded,
    const questionnaires::BlankTexts& texts,
    questionnaires::Problems& problems);

}  // namespace protocols
