#pragma once

#include <string>
#include <vector>

#include "protocols/model/loaded_protocol.h"

namespace study::collect {

/// The files of a protocol as the server stores them: a JSON object, name to text.
std::string filesAsText(const std::vector<protocols::SourceFile>& files);
std::vector<protocols::SourceFile> filesIn(const std::string& text);

/// Loads a protocol from its text and files.
/// @throws UserError  if this version of the program cannot read it.
protocols::LoadedProtocol protocolOf(
    const std::string& text, const std::vector<protocols::SourceFile>& files);

}  // namespace study::collect
