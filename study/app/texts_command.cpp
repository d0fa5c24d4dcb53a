// Lists and fills in the blanks in texts that participants read.
#include <cstdio>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "base/joined.h"
#include "base/search.h"
#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "study/app/command_options.h"
#include "study/app/json_file.h"
#include "study/model/new_file.h"
#include "study/model/user_error.h"
#include "study/session/session_length.h"
#include "study/session/study.h"
#include "study/words/counted.h"

namespace study::app {
namespace {

using questionnaires::BlankTexts;
using questionnaires::LocalizedText;

struct TextsArguments {
  std::string source;  ///< a protocol file, or the folder of a study
  std::vector<std::string> set;
  std::string out;
  std::string reason;
  bool json = false;
};

/// Puts "institution=NTNU" or "de:institution=NTNU" into @p texts. An empty value removes the text
/// in that language.
void setBlankText(
    const std::string& assignment, const std::vector<std::string>& languages, BlankTexts& texts) {
  const auto equals = assignment.find('=');
  if (equals == std::string::npos || equals == 0) {
    throw UserError(
        "'" + assignment + "' is not KEY=TEXT. Write for example --set \"institution=NTNU\".");
  }
  auto key = assignment.substr(0, equals);
  std::string language = "en";
  if (const auto colon = key.find(':'); colon != std::string::npos) {
    language = key.substr(0, colon);
    key = key.substr(colon + 1);
  }
  if (!base::contains(languages, language)) {
    throw UserError(fmt::format(
        "'{}': the protocol has no texts in '{}', only in {}.",
        assignment,
        language,
        base::joined(languages, ", ")));
  }
  auto byLanguage = texts[key].all();
  byLanguage[language] = assignment.substr(equals + 1);
  if (byLanguage[language].empty()) byLanguage.erase(language);
  texts[key] = LocalizedText(std::move(byLanguage));
  if (texts[key].isEmpty()) texts.erase(key);
}

protocols::LoadedProtocol withFilledBlanks(
    const protocols::LoadedProtocol& loaded, const std::vector<std::string>& assignments) {
  auto texts = loaded.protocol.texts;
  for (const auto& assignment : assignments)
    setBlankText(assignment, loaded.protocol.languages, texts);
  questionnaires::Problems problems;
  auto filled = protocols::withTexts(loaded, texts, problems);
  if (!filled) {
    throw UserError(
        "The texts cannot be filled in like this:\n" + questionnaires::describe(problems.all()));
  }
  for (const auto& [key, text] : filled->protocol.texts) {
    const auto& blanks = filled->blanks;
    if (base::contains(blanks, key)) continue;
    throw UserError(
        "No text has the blank '" + key + "'. 'palpate protocol texts' lists the keys.");
  }
  return std::move(*filled);
}

std::string inWords(const LocalizedText& text) {
  if (text.isEmpty()) return "(blank)";
  std::string words = text.in("en");
  for (const auto& [language, other] : text.all()) {
    if (language != "en") words += "; " + language + ": " + other;
  }
  return words;
}

int listBlanks(const protocols::LoadedProtocol& loaded, bool json) {
  const auto blanks = protocols::blanksOf(loaded);
  if (json) {
    std::fputs(blanksAsJson(blanks).c_str(), stdout);
    return 0;
  }
  std::size_t left = 0;
  for (const auto& blank : blanks) {
    left += blank.text.isEmpty() ? 1 : 0;
    fmt::print(
        "{:<26} {}\n{:<26} {}\n", blank.key, base::describe(blank.title), "", inWords(blank.text));
  }
  fmt::print("{} of {} blanks are filled in.\n", blanks.size() - left, blanks.size());
  if (left > 0) {
    fmt::print(
        "By the timeline a session takes about {} minutes.\n",
        minutesOf(lengthOf(loaded, {}).seconds));
  }
  return 0;
}

int listOrFillProtocolTexts(const TextsArguments& options) {
  const auto loaded = loadValidProtocol(options.source);
  if (options.set.empty()) return listBlanks(loaded, options.json);
  if (options.out.empty()) {
    throw UserError("Name a new file for the filled-in protocol: add --out FILE.json.");
  }
  const auto filled = withFilledBlanks(loaded, options.set);
  writeNewFile(options.out, filled.text);
  listBlanks(filled, options.json);
  if (!options.json) fmt::print("Protocol saved: {}\n", options.out);
  return 0;
}

int listOrFillStudyTexts(const TextsArguments& options) {
  if (options.set.empty()) {
    auto study = Study::open(options.source, storage::Database::Access::ReadOnly);
    return listBlanks(study.protocol(), options.json);
  }
  auto study = Study::open(options.source);
  const auto filled = withFilledBlanks(study.protocol(), options.set);
  study.amend(filled, options.reason);
  listBlanks(filled, options.json);
  if (options.json) return 0;
  fmt::print("New sessions show these texts from now on.\n");
  printNeedOfServer(study);
  return 0;
}

AddedCommand<TextsArguments> addTexts(
    CLI::App& parentCommand,
    Action& action,
    const char* help,
    int (*perform)(const TextsArguments&)) {
  auto added = addCommand(parentCommand, action, "texts", help, perform);
  added.command
      ->add_option(
          "--set",
          added.options.set,
          "Blank to fill in: KEY=TEXT, or de:KEY=TEXT for its German text; repeatable")
      ->allow_extra_args(false);
  added.command->add_flag("--json", added.options.json, "Print JSON");
  return added;
}

}  // namespace

void addProtocolTextsCommand(CLI::App& parentCommand, Action& action) {
  auto [verb, options] = addTexts(
      parentCommand,
      action,
      "List the blanks in texts that participants read, or fill them in",
      listOrFillProtocolTexts);
  addProtocolFile(*verb, options.source);
  verb->add_option("--out", options.out, "New file for the filled-in protocol")->type_name("FILE");
}

void addStudyTextsCommand(CLI::App& parentCommand, Action& action) {
  auto [verb, options] = addTexts(
      parentCommand,
      action,
      "List the blanks in a study's texts, or fill them in by an amendment",
      listOrFillStudyTexts);
  addStudyFolder(*verb, options.source);
  addReasonOfAmendment(*verb, options.reason);
}

}  // namespace study::app
