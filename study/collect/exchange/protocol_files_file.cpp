#include <nlohmann/json.hpp>

#include "protocols/load_protocol.h"
#include "study/collect/exchange/protocol_files.h"
#include "study/model/user_error.h"

namespace study::collect {

std::string filesAsText(const std::vector<protocols::SourceFile>& files) {
  auto object = nlohmann::json::object();
  for (const auto& file : files) object[file.name] = file.text;
  return object.dump();
}

std::vector<protocols::SourceFile> filesIn(const std::string& text) {
  std::vector<protocols::SourceFile> files;
  const auto object = nlohmann::json::parse(text, nullptr, false);
  if (!object.is_object()) return files;
  for (const auto& [name, content] : object.items()) {
    if (content.is_string()) files.push_back({name, content.get<std::string>()});
  }
  return files;
}

protocols::LoadedProtocol protocolOf(
    const std::string& text, const std::vector<protocols::SourceFile>& files) {
  questionnaires::Problems problems;
  auto protocol = protocols::loadProtocol(text, files, problems);
  if (!protocol) {
    throw UserError(
        "The study's protocol cannot be read by this version of palpate. Install the release of "
        "the study's administrator:\n" +
        questionnaires::describe(problems.all()));
  }
  // the hash of a protocol covers these files, without forms of the library
  protocol->files = files;
  return std::move(*protocol);
}

}  // namespace study::collect
