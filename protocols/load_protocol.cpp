#include "protocols/load_protocol.h"

#include <filesystem>
#include <utility>

#include "base/search.h"
#include "protocols/reading/anatomy_file.h"
#include "protocols/reading/packing_file.h"
#include "protocols/reading/protocol_file.h"
#include "protocols/validation/validation.h"
#include "questionnaires/json/document.h"

namespace protocols {
namespace {

namespace fs = std::filesystem;
using questionnaires::Problems;

constexpr std::string_view kProtocolExtension = ".json";
constexpr std::string_view kSchemaExtension = ".schema.json";

/// Adds @p found to @p problems. If @p found has errors, its warnings are left out.
void append(const Problems& found, Problems& problems) {
  if (!found.hasErrors()) return problems.append(found);
  for (const auto& problem : found.all()) {
    if (problem.severity == questionnaires::Severity::Error) problems.add(problem);
  }
}

/// The largest size of a file with this name [bytes].
std::size_t largestFileSizeOf(const std::string& name) {
  if (name.ends_with(kPackingExtension)) return kMaxPackingBytes;
  return name.ends_with(kAnatomyExtension) ? kMaxAnatomyBytes : questionnaires::kLargestFile;
}

/// Where a protocol comes from.
enum class Origin {
  NewFile,  ///< a file of which a study may be made
  Study     ///< an existing study, or a text whose limits are not checked
};

std::optional<LoadedProtocol> load(
    std::string_view json,
    const FileFinder& find,
    Problems& problems,
    Defaults defaults,
    Origin origin,
    const FileFinder& copies = {}) {
  auto draft = readUnvalidatedProtocol(json, find, problems, defaults, copies);
  if (!draft) return std::nullopt;
  validate(*draft, problems);
  if (defaults == Defaults::Current) validateBenchmarks(*draft, problems);
  if (origin == Origin::NewFile) validateNewFile(*draft, problems);
  if (problems.hasErrors()) return std::nullopt;
  addWarnings(draft->loaded, problems, defaults);
  fillInLabels(draft->loaded);
  return std::move(draft->loaded);
}

}  // namespace

std::vector<std::string> libraryProtocols() {
  std::vector<std::string> names;
  for (const auto& file : libraryFiles()) {
    if (file.name.ends_with(kSchemaExtension) || !file.name.ends_with(kProtocolExtension)) continue;
    names.emplace_back(file.name.substr(0, file.name.size() - kProtocolExtension.size()));
  }
  return names;
}

std::optional<std::string_view> libraryProtocol(std::string_view name) {
  for (const auto& file : libraryFiles()) {
    if (file.name == std::string(name) + std::string(kProtocolExtension)) return file.content;
  }
  return std::nullopt;
}

std::optional<LoadedProtocol> loadProtocol(
    std::string_view json, const FileFinder& find, Problems& problems, Defaults defaults) {
  Problems found;
  auto loaded = load(json, find, found, defaults, Origin::Study);
  append(found, problems);
  return loaded;
}

std::optional<LoadedProtocol> loadProtocol(
    std::string_view json,
    const std::vector<SourceFile>& files,
    Problems& problems,
    Defaults defaults) {
  const FileFinder find = [&](const std::string& name) -> std::optional<std::string> {
    for (const auto& file : files) {
      if (file.name == name) return file.text;
    }
    return std::nullopt;
  };
  Problems found;
  auto loaded = load(json, find, found, defaults, Origin::Study, find);
  append(found, problems);
  return loaded;
}

namespace {

/// Whether @p file lies in @p folder once symbolic links are followed.
bool isInside(const fs::path& file, const fs::path& folder) {
  const auto inFolder = fs::canonical(file).lexically_relative(fs::canonical(folder));
  return !inFolder.empty() && *inFolder.begin() != "..";
}

std::optional<LoadedProtocol> loadNew(
    std::string_view json, const FileFinder& find, Problems& problems) {
  Problems found;
  auto loaded = load(json, find, found, Defaults::Current, Origin::NewFile);
  append(found, problems);
  return loaded;
}

}  // namespace

std::optional<LoadedProtocol> loadProtocolFile(const std::string& path, Problems& problems) {
  std::error_code ignored;
  // a folder, such as that of a study, may have the name of a protocol in the library
  const bool isFile = fs::is_regular_file(path, ignored);
  const bool hasEnding = path.ends_with(kProtocolExtension);
  const auto name = hasEnding ? path.substr(0, path.size() - kProtocolExtension.size()) : path;
  if (const auto text = isFile ? std::nullopt : libraryProtocol(name)) {
    return loadNew(
        *text, [](const std::string&) { return std::nullopt; }, problems);
  }
  const bool isName = fs::path(path).filename() == path && !fs::path(path).has_extension();
  if (isName && !fs::exists(path, ignored)) {
    throw base::UserError(
        "There is no protocol " + path +
        " in the library, and no file of that name. 'palpate protocol list' names those of the "
        "library.");
  }
  const auto folder = fs::path(path).parent_path();
  const auto findBeside = [&](const std::string& other) -> std::optional<std::string> {
    const auto file = folder / other;
    std::error_code absent;
    if (!fs::exists(file, absent)) return std::nullopt;
    // The file's text is stored in the study, and exported with it. A protocol from elsewhere must
    // not be able to choose any file of this computer for that.
    if (!isInside(file, folder.empty() ? "." : folder)) {
      throw base::UserError(
          "It is a link to a file outside the protocol's folder. Put a copy of that file in place "
          "of the link.");
    }
    return questionnaires::readTextFile(file.string(), largestFileSizeOf(other));
  };
  const auto text = questionnaires::readTextFile(path);
  if (fs::path(path).extension() == ".csv") {
    problems.add(
        "$",
        "this is a table (CSV), not a protocol",
        "import it as a cut, and name that as the 'cut' of a condition in a protocol");
    return std::nullopt;
  }
  return loadNew(text, findBeside, problems);
}

std::optional<LoadedProtocol> withTexts(
    const LoadedProtocol& loaded, const questionnaires::BlankTexts& texts, Problems& problems) {
  return loadProtocol(withTexts(loaded.text, texts), loaded.files, problems);
}

questionnaires::BlankTexts keptTexts(const LoadedProtocol& before, const LoadedProtocol& changed) {
  const auto& languages = changed.protocol.languages;
  questionnaires::BlankTexts kept;
  for (const auto& key : changed.blanks) {
    const auto text = before.protocol.texts.find(key);
    if (text == before.protocol.texts.end() || changed.protocol.texts.contains(key)) continue;
    auto translations = text->second.all();
    std::erase_if(translations, [&](const auto& each) {
      return each.first != "en" && !base::contains(languages, each.first);
    });
    kept.emplace(key, questionnaires::LocalizedText(std::move(translations)));
  }
  return kept;
}

LoadedProtocol withKeptTexts(const LoadedProtocol& before, const LoadedProtocol& changed) {
  auto texts = keptTexts(before, changed);
  if (texts.empty()) return changed;
  texts.insert(changed.protocol.texts.begin(), changed.protocol.texts.end());
  Problems unused;  // warnings, as those of changed
  auto filled = withTexts(changed, texts, unused);
  return filled ? std::move(*filled) : changed;
}

}  // namespace protocols
