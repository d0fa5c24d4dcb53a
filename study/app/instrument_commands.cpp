#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_file.h"
#include "questionnaires/reading/instrument_reader.h"
#include "questionnaires/reading/wording.h"
#include "study/app/command_options.h"
#include "study/model/new_file.h"

namespace study::app {
namespace {

namespace fs = std::filesystem;
using questionnaires::Instrument;
using questionnaires::Item;
using questionnaires::Score;
using questionnaires::shown;

struct InstrumentArguments {
  std::string name;
  std::string folder;
  std::string language = "en";
  std::string out;
};

/// The text of an instrument in a file or in the library.
std::string textOf(const std::string& name) {
  std::error_code ignored;
  if (!fs::is_regular_file(name, ignored)) {
    for (const auto& file : questionnaires::libraryFiles()) {
      const bool isSchema = file.name.ends_with(".schema.json");
      if (!isSchema && (file.name == name || file.name == name + ".json")) {
        return std::string(file.content);
      }
    }
  }
  return questionnaires::readTextFile(name);
}

Instrument readOrExplain(const std::string& name) {
  return questionnaires::readValidInstrument(textOf(name), name);
}

/// The folder of the wording files: the folder of the instrument's file; for a library instrument
/// the current directory.
fs::path folderOf(const InstrumentArguments& options) {
  if (!options.folder.empty()) return options.folder;
  std::error_code ignored;
  return fs::is_regular_file(options.name, ignored) ? fs::path(options.name).parent_path()
                                                    : fs::path();
}

int list(const InstrumentArguments& /*options*/) {
  for (const auto& file : questionnaires::libraryFiles()) {
    if (file.name.ends_with(".schema.json")) continue;
    const auto instrument =
        questionnaires::readValidInstrument(file.content, std::string(file.name));
    std::string languages;
    for (const auto& language : instrument.languages) languages += " " + language;
    fmt::print(
        "{:<22} {:>3} items {:<10} {}{}\n",
        instrument.id,
        instrument.items.size(),
        languages,
        instrument.title.in("en"),
        instrument.hasWithheldTexts() ? " (its words come from a wording file)" : "");
  }
  return 0;
}

int check(const InstrumentArguments& options) {
  questionnaires::Problems problems;
  auto instrument = questionnaires::readInstrument(textOf(options.name), problems);
  if (instrument) {
    const auto folder = folderOf(options);
    const auto find = [&](const std::string& name) -> std::optional<std::string> {
      std::error_code absent;
      if (!fs::exists(folder / name, absent)) return std::nullopt;
      return questionnaires::readTextFile((folder / name).string());
    };
    questionnaires::completeWording(*instrument, {options.language}, find, "$.items", problems);
  }
  std::fputs(questionnaires::describe(problems.all()).c_str(), stdout);
  if (problems.hasErrors()) {
    fmt::print("{} cannot be used yet.\n", options.name);
    return 1;
  }
  std::string languages;
  for (const auto& language : instrument->languages) languages += " " + language;
  fmt::print("{} can be asked in:{}.\n", options.name, languages);
  return 0;
}

std::string keyLineOf(const Item& item) {
  const auto range = questionnaires::rangeOf(item);
  if (!range) return {};
  const std::string counts =
      item.key == -1 ? "reversed: x counts " + shown(range->low + range->high) + " - x" : "";
  const std::string threshold =
      item.acceptableFrom ? "acceptable from " + shown(*item.acceptableFrom) : "";
  std::string line =
      fmt::format("{:<28} {} ... {}", item.id, shown(range->low), shown(range->high));
  for (const auto& words : {counts, threshold}) {
    if (!words.empty()) line += "  " + words;
  }
  return line + "\n";
}

std::string weightedNames(const Score& score) {
  std::string names;
  for (std::size_t i = 0; i < score.items.size(); ++i) {
    names += names.empty() ? "" : ", ";
    const bool hasWeight = i < score.weights.size() && score.weights[i] != 1.0;
    names += (hasWeight ? shown(score.weights[i]) + " * " : "") + score.items[i];
  }
  return names;
}

std::string aggregateOf(const Score& score) {
  const bool isWeighted = !score.weights.empty() || !score.weightsFrom.empty();
  const std::string names = "(" + weightedNames(score) + ")";
  switch (score.aggregate) {
    case Score::Aggregate::Sum:
      return (isWeighted ? "weighted sum" : "sum") + names;
    case Score::Aggregate::Count:
      return "how many are at least " + shown(score.countFrom) + " of " + names;
    case Score::Aggregate::Mean:
      break;
  }
  return (isWeighted ? "weighted mean" : "mean") + names;
}

std::string missingRuleOf(const Score& score) {
  const bool needsAll = score.leastAnswered == 0 || score.leastAnswered >= score.items.size();
  if (needsAll) return "every answer is needed";
  std::string words = score.leastAnswered == 1
                          ? "at least one answer is needed"
                          : fmt::format("at least {} answers are needed", score.leastAnswered);
  if (score.missingAs) words += ", a missing one counts as " + shown(*score.missingAs);
  return words;
}

std::string formulaOf(const Score& score) {
  std::string formula = aggregateOf(score);
  if (score.offset != 0.0) {
    formula = fmt::format(
        "({} {} {})", formula, score.offset < 0.0 ? "-" : "+", shown(std::abs(score.offset)));
  }
  if (score.factor != 1.0) formula += " * " + shown(score.factor);
  return formula;
}

/// The scoring key as text: a line for each scored item and for each score with its formula, to be
/// compared with the publication before the study begins.
std::string describeKeys(const Instrument& instrument) {
  std::string text;
  for (const auto& item : instrument.items) text += keyLineOf(item);
  for (const auto& score : instrument.scores) {
    text += fmt::format("\n{}: {}\n  = {}\n", score.id, score.title.in("en"), formulaOf(score));
    text += "  " + missingRuleOf(score);
    if (!score.reverseByKey) text += "; nothing is reversed";
    if (!score.weightsFrom.empty()) {
      text += fmt::format(
          "; the weights are how often each was chosen in {} pairs", score.weightsFrom.size());
    }
    text += "\n";
  }
  if (instrument.occasions == questionnaires::Occasions::BeforeAndAfter) {
    text += "\nAsked before and after: the result of each score is after - before.\n";
  }
  if (const auto& rule = instrument.consistency) {
    text += fmt::format(
        "\nSuspicious where the answers within {} of {} scores lie more than {} apart.\n",
        rule->suspiciousFrom,
        rule->scores.size(),
        shown(rule->widestRange));
  }
  return text.empty() ? "Nothing is scored here.\n" : text;
}

int keys(const InstrumentArguments& options) {
  std::fputs(describeKeys(readOrExplain(options.name)).c_str(), stdout);
  return 0;
}

int wording(const InstrumentArguments& options) {
  const auto instrument = readOrExplain(options.name);
  const auto missing = questionnaires::missingTexts(instrument, options.language);
  if (missing.empty()) {
    fmt::print("{} has all its words in '{}' already.\n", instrument.id, options.language);
    return 0;
  }
  const std::string text = questionnaires::wordingTemplate(instrument, options.language);
  if (options.out.empty()) {
    std::fputs(text.c_str(), stdout);
    return 0;
  }
  const fs::path file(options.out);
  std::error_code error;
  if (file.has_parent_path()) fs::create_directories(file.parent_path(), error);
  writeNewFile(options.out, text);
  fmt::print(
      "{} has room for {} texts. Fill them in, with their source. Palpate looks for them in {}, in "
      "the folder of the protocol.\n",
      options.out,
      missing.size(),
      questionnaires::wordingFileName(instrument.id, options.language));
  return 0;
}

void addName(CLI::App& verb, std::string& name) {
  verb.add_option("NAME", name, "Instrument file (.json), or a name from 'palpate instrument list'")
      ->required();
}

void addLanguage(CLI::App& verb, std::string& language) {
  verb.add_option("--language", language, "Language of the texts: en, de, nb …")
      ->check([](const std::string& tag) {
        return questionnaires::isLanguageTag(tag) ? std::string()
                                                  : "'" + tag + "' is no language tag";
      })
      ->capture_default_str();
}

}  // namespace

void addInstrumentCommands(CLI::App& program, Action& action) {
  auto& parentCommand = addCommandGroup(
      program,
      "instrument",
      "Questionnaires: list, check, scoring keys, files for licensed or translated texts");
  addCommand(parentCommand, action, "list", "List the instruments of the library", app::list);

  auto [check, checking] = addCommand(
      parentCommand,
      action,
      "check",
      "List all problems of an instrument and its wording files",
      app::check);
  addName(*check, checking.name);
  check
      ->add_option(
          "--folder",
          checking.folder,
          "Folder that contains the folder 'wording' (default: where the instrument file is; for "
          "an instrument of the library, the current folder)")
      ->type_name("FOLDER");
  addLanguage(*check, checking.language);

  auto [keys, scoring] = addCommand(
      parentCommand,
      action,
      "keys",
      "Print how an instrument is scored: its reversed items and its formulas",
      app::keys);
  addName(*keys, scoring.name);

  auto [wording, writing] = addCommand(
      parentCommand,
      action,
      "wording",
      "Write a wording file to fill in: texts under licence, or a translation",
      app::wording);
  addName(*wording, writing.name);
  addLanguage(*wording, writing.language);
  wording->add_option("--out", writing.out, "New file (default: print to the terminal)")
      ->type_name("FILE");
}

}  // namespace study::app
