#include "questionnaires/reading/instrument_file.h"

#include <algorithm>
#include <array>
#include <set>
#include <string>
#include <utility>

#include "base/search.h"
#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_problems.h"
#include "questionnaires/reading/instrument_reader.h"

namespace questionnaires {

void BlankFiller::note(const std::string& key) {
  if (!base::contains(keys_, key)) keys_.push_back(key);
}

std::string BlankFiller::filled(const std::string& text, const std::string& language) {
  constexpr std::size_t kBrackets = 2;
  std::string result;
  std::size_t from = 0;
  for (auto start = text.find("[["); start != std::string::npos; start = text.find("[[", from)) {
    const auto end = text.find("]]", start);
    if (end == std::string::npos) break;
    const auto key = text.substr(start + kBrackets, end - start - kBrackets);
    note(key);
    const auto found = texts_.find(key);
    const auto next = end + kBrackets;
    result += text.substr(from, start - from);
    result += found == texts_.end() ? text.substr(start, next - start) : found->second.in(language);
    from = next;
  }
  return result + text.substr(from);
}

void BlankFiller::fill(LocalizedText& text) {
  auto byLanguage = text.all();
  for (auto& [language, words] : byLanguage) words = filled(words, language);
  text = LocalizedText(std::move(byLanguage));
}

void BlankFiller::fill(Instrument& instrument) {
  for (const auto& place : textPlacesOf(instrument)) {
    for (auto* text : place.texts) fill(*text);
  }
}

namespace {

constexpr std::string_view kSchema = "instrument-1.schema.json";
constexpr std::array kOccasions{
    Choice<Occasions>{"once", Occasions::Once},
    Choice<Occasions>{"before_and_after", Occasions::BeforeAndAfter},
};

bool isDoi(std::string_view doi) {
  constexpr std::size_t kLongest = 200;
  const auto isPlain = [](char c) { return c > ' ' && c <= '~'; };
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  if (doi.size() > kLongest || doi.substr(0, 3) != "10.") return false;
  doi.remove_prefix(3);
  const std::size_t slash = std::min(doi.find('/'), doi.size());
  const std::string_view registrant = doi.substr(0, slash);
  return registrant.size() >= 4 && registrant.size() <= 9 && slash + 1 < doi.size() &&
         std::ranges::all_of(registrant, isDigit) && std::ranges::all_of(doi, isPlain);
}

Source readSource(const Node& root) {
  Source source;
  const auto node = root.requiredObject("source");
  if (!node ||
      !node->isObjectWithOnlyKeys({"citation", "doi", "licence", "note", "wording_from"})) {
    return source;
  }
  source.citation = node->text("citation");
  source.licence = node->text("licence");
  if (node->has("note")) source.note = node->text("note");
  if (node->has("wording_from")) source.wordingFrom = node->text("wording_from");
  source.doi = node->text("doi", "");
  if (node->has("doi") && node->member("doi")->isText() && !isDoi(source.doi)) {
    node->problem(
        "doi",
        "'" + shown(source.doi) + "' is no DOI",
        "write it as 10.9781/ijimai.2017.09.001, without https://doi.org/");
  }
  return source;
}

void readLists(const Node& root, const TextReader& texts, Instrument& instrument) {
  if (const auto scale = root.member("scale")) instrument.scale = readScale(*scale, texts);
  if (!root.has("items")) {
    root.problem("items", "'items' is missing", "add it; write [] where nothing is asked");
  }
  const ItemReader reader(texts, instrument.scale);
  for (const auto& node : root.list("items", kMostItems)) {
    instrument.items.push_back(reader.read(node, instrument.items.size()));
  }
  for (const auto& node : root.list("scores", kMostScores)) {
    instrument.scores.push_back(readScore(node, texts, instrument.scores.size()));
  }
  if (const auto rule = root.object("consistency")) {
    instrument.consistency = readConsistencyRule(*rule);
  }
}

Instrument readRoot(const Node& root) {
  Instrument instrument;
  root.requireFormat("$schema", kSchema);
  instrument.id = idOrGenerated(root, "id", 0);
  instrument.version = root.id("version");
  instrument.languages = languagesIn(root.requiredList("languages"));
  if (!root.has("languages")) instrument.languages = {"en"};
  const TextReader texts(instrument.languages);
  instrument.title = texts.required(root, "title");
  instrument.introduction = texts.optional(root, "introduction");
  instrument.source = readSource(root);
  instrument.occasions = root.choice("occasions", kOccasions, Occasions::Once);
  readLists(root, texts, instrument);
  return instrument;
}

/// Adds the problems of problemsOf(), except at places where reading has already found a problem.
/// Warnings are added only if there are no errors.
void addNewContent(const Problems& more, Problems& problems) {
  std::set<std::string> places;
  for (const auto& problem : problems.all()) places.insert(problem.path);
  const bool wasSound = !problems.hasErrors();
  for (const auto& problem : more.all()) {
    const bool isError = problem.severity == Severity::Error;
    if (isError ? places.count(problem.path) == 0 : wasSound) problems.add(problem);
  }
}

}  // namespace

std::optional<Instrument> readInstrument(
    std::string_view json, Problems& problems, BlankFiller* blanks) {
  Problems found;
  std::optional<Instrument> instrument;
  const auto value = parseJson(json, found);
  if (value) {
    const Node root(*value, "$", found);
    if (root.isObjectWithOnlyKeys(
            {"$schema",
             "id",
             "version",
             "title",
             "introduction",
             "source",
             "languages",
             "scale",
             "items",
             "scores",
             "occasions",
             "consistency"})) {
      instrument = readRoot(root);
      if (blanks != nullptr) blanks->fill(*instrument);
      addNewContent(problemsOf(*instrument), found);
    }
  }
  problems.append(found);
  return found.hasErrors() ? std::nullopt : instrument;
}

Instrument readValidInstrument(std::string_view json, const std::string& name) {
  Problems problems;
  auto instrument = readInstrument(json, problems);
  if (!instrument) {
    throw base::UserError(
        "The questionnaire " + name + " cannot be used:\n" + describe(problems.all()));
  }
  return *std::move(instrument);
}

}  // namespace questionnaires
