// A protocol and the files that it names: found, read once, kept as they were.
#include "protocols/model/loaded_protocol.h"

#include <sys/stat.h>

#include <algorithm>
#include <filesystem>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "haptics/recordings/cut.h"
#include "protocols/load_protocol.h"
#include "questionnaires/json/document.h"
#include "questionnaires/reading/instrument_file.h"
#include "questionnaires/reading/wording.h"
#include "tests/protocols/small_protocol.h"
#include "tests/support/scratch_folder.h"

namespace protocols {
namespace loaded_protocol_test {

namespace fs = std::filesystem;
namespace engine = haptics::engine;
using questionnaires::Problems;
using Words = std::vector<std::string>;

/// usualProtocol() that names these files as a JSON list.
std::string naming(const std::string& files) {
  return tests::with(
      tests::usualProtocol(),
      "\"conditions\": [\n",
      "\"instrument_files\": " + files + ",\n  \"conditions\": [\n");
}

/// usualProtocol() whose second condition is the cut in a file.
std::string feeling(const std::string& cut) {
  return tests::with(
      tests::usualProtocol(),
      R"("model": "finite-elements",
        "parameters": { "yield_force_n": 6 })",
      R"("model": "interpolation", "parameters": {"cut": ")" + cut + R"("})");
}

std::string instrumentFile(const std::string& id) {
  return tests::with(
      tests::corpusText("good", "instruments/comfort"), "\"comfort\"", "\"" + id + "\"");
}

std::string cutFile() {
  return tests::corpusText("good", "cuts/two-points");
}

/// Finds files among some, and counts how often each is asked for.
struct Shelf {
  std::map<std::string, std::string> files;
  std::map<std::string, int> asked{};

  FileFinder finder() {
    return [this](const std::string& name) -> std::optional<std::string> {
      ++asked[name];
      const auto file = files.find(name);
      return file == files.end() ? std::nullopt : std::optional(file->second);
    };
  }
};

/// The names of its files without the copies of the library's.
Words ownFilesOf(const LoadedProtocol& loaded) {
  Words names;
  for (const auto& file : loaded.files) {
    if (!file.name.starts_with(kLibraryCopyPrefix)) names.push_back(file.name);
  }
  return names;
}

/// The errors of a refused protocol.
Words errorsIn(const std::string& json, const FileFinder& find = {}) {
  const auto loading = tests::load(json, find);
  EXPECT_FALSE(loading.loaded.has_value());
  Words said;
  for (const auto& problem : loading.problems) {
    EXPECT_EQ(problem.severity, questionnaires::Severity::Error);
    said.push_back(problem.path + ": " + base::describe(problem.what));
  }
  return said;
}

TEST(LoadedProtocol, HoldsTheInstrumentsThatItUsesAndNoOthers) {
  const auto loading = tests::load(tests::usualProtocol());
  ASSERT_TRUE(loading.loaded.has_value()) << loading.describe();
  Words ids;
  for (const auto& instrument : loading.loaded->instruments) ids.push_back(instrument.id);
  EXPECT_EQ(ids, (Words{"consent-punch", "realism-cuts"}));
  EXPECT_EQ(loading.loaded->instrument("realism-cuts")->items.size(), 6U);
  EXPECT_EQ(loading.loaded->instrument("debrief"), nullptr);
}

TEST(LoadedProtocol, KeepsItsOwnTextAndThatOfItsFilesByteByByte) {
  const auto protocol = tests::with(
      feeling("cuts/mine.json"),
      "\"conditions\": [\n",
      "\"instrument_files\": [\"mine.json\"],\n  \"conditions\": [\n");
  Shelf shelf{.files = {{"mine.json", instrumentFile("mine")}, {"cuts/mine.json", cutFile()}}};
  const auto loading = tests::load(protocol, shelf.finder());
  ASSERT_TRUE(loading.loaded.has_value()) << loading.describe();
  EXPECT_EQ(loading.loaded->text, protocol);
  ASSERT_EQ(ownFilesOf(*loading.loaded), (Words{"cuts/mine.json", "mine.json"}));
  EXPECT_EQ(loading.loaded->files[0].name, "cuts/mine.json");
  EXPECT_EQ(loading.loaded->files[0].text, shelf.files.at("cuts/mine.json"));
  EXPECT_EQ(loading.loaded->files[1].name, "mine.json");
  EXPECT_EQ(loading.loaded->files[1].text, shelf.files.at("mine.json"));
}

TEST(LoadedProtocol, KeepsNoDataThatAreBuiltIn) {
  const auto loading = tests::load(feeling("parametric"));
  ASSERT_TRUE(loading.loaded.has_value()) << loading.describe();
  EXPECT_TRUE(ownFilesOf(*loading.loaded).empty());
}

TEST(LoadedProtocol, KeepsACopyOfEachInstrumentOfTheLibraryThatItUses) {
  const auto loading = tests::load(tests::usualProtocol());
  ASSERT_TRUE(loading.loaded.has_value()) << loading.describe();
  Words names;
  for (const auto& file : loading.loaded->files) {
    names.push_back(file.name);
    const auto in = std::find_if(
        questionnaires::libraryFiles().begin(),
        questionnaires::libraryFiles().end(),
        [&](const auto& own) { return "palpate-library/" + std::string(own.name) == file.name; });
    ASSERT_NE(in, questionnaires::libraryFiles().end()) << file.name;
    EXPECT_EQ(file.text, in->content);
  }
  EXPECT_EQ(
      names, (Words{"palpate-library/consent-punch.json", "palpate-library/realism-cuts.json"}));
}

/// Loaded from its text and @p files, as a study keeps them.
std::optional<LoadedProtocol> kept(const std::string& text, const std::vector<SourceFile>& files) {
  Problems problems;
  auto loaded = loadProtocol(text, files, problems);
  EXPECT_TRUE(loaded) << questionnaires::describe(problems.all());
  return loaded;
}

TEST(LoadedProtocol, ReadsItsCopiesInPlaceOfTheLibrary) {
  const auto text = tests::usualProtocol();
  auto files = kept(text, {})->files;
  for (auto& file : files)
    file.text = tests::with(file.text, "\"version\": \"", "\"version\": \"9");
  const auto loaded = kept(text, files);
  for (const auto& instrument : loaded->instruments) {
    EXPECT_EQ(instrument.version.front(), '9') << instrument.id;
  }
}

TEST(LoadedProtocol, ReadsItsCopiesThoughTheLibraryHasThemNoMore) {
  const auto text = tests::with(tests::usualProtocol(), "\"realism-cuts\"", "\"gone\"");
  auto files = kept(tests::usualProtocol(), {})->files;
  auto& form = files.back();
  ASSERT_EQ(form.name, "palpate-library/realism-cuts.json");
  form = {"palpate-library/gone.json", tests::with(form.text, "\"realism-cuts\"", "\"gone\"")};
  EXPECT_EQ(kept(text, files)->instrument("gone")->items.size(), 6U);
}

TEST(LoadedProtocol, LooksForNoCopiesBesideAProtocol) {
  Shelf shelf;
  EXPECT_TRUE(tests::load(tests::usualProtocol(), shelf.finder()).loaded.has_value());
  EXPECT_TRUE(shelf.asked.empty());
}

TEST(LoadedProtocol, CanBeLoadedAgainFromWhatItKeeps) {
  Shelf shelf{.files = {{"mine.json", cutFile()}}};
  const auto first = tests::load(feeling("mine.json"), shelf.finder());
  ASSERT_TRUE(first.loaded.has_value()) << first.describe();
  Shelf kept;
  for (const auto& file : first.loaded->files) kept.files[file.name] = file.text;
  const auto second = tests::load(first.loaded->text, kept.finder());
  ASSERT_TRUE(second.loaded.has_value()) << second.describe();
  EXPECT_EQ(second.describe(), first.describe());
}

TEST(LoadedProtocol, PutsTheCurveOfACutIntoItsScene) {
  Shelf shelf{.files = {{"mine.json", cutFile()}}};
  const auto loading = tests::load(feeling("mine.json"), shelf.finder());
  ASSERT_TRUE(loading.loaded.has_value()) << loading.describe();
  const auto& scene = loading.loaded->protocol.condition("firm")->scene();
  const auto& curve = std::get<engine::InterpolationSpec>(scene.model).curve;
  ASSERT_EQ(curve.size(), 2U);
  EXPECT_EQ(curve[1].travel, 10.5);
  EXPECT_EQ(curve[1].force, 4.25);
}

TEST(LoadedProtocol, PutsTheShippedCutIntoAFusedSceneThatNamesNone) {
  const auto text = tests::with(
      tests::usualProtocol(),
      R"("model": "finite-elements",
        "parameters": { "yield_force_n": 6 })",
      R"("model": "kalman", "parameters": {})");
  const auto loading = tests::load(text);
  ASSERT_TRUE(loading.loaded.has_value()) << loading.describe();
  const auto& scene = loading.loaded->protocol.condition("firm")->scene();
  const auto& curve = std::get<engine::KalmanSpec>(scene.model).interpolation.curve;
  EXPECT_EQ(curve.size(), haptics::recordings::parametricCut().curve.nodes().size() + 1);
  EXPECT_EQ(curve.back().force, 0.0);
}

TEST(LoadedProtocol, LetsTheShippedCutEndAtItsLargestForceInAStudyOfRelease01) {
  const auto text = tests::with(
      tests::usualProtocol(),
      R"("model": "finite-elements",
        "parameters": { "yield_force_n": 6 })",
      R"("model": "interpolation", "parameters": {})");
  questionnaires::Problems problems;
  const auto nothing = [](const std::string&) { return std::nullopt; };
  const auto loaded = loadProtocol(text, nothing, problems, Defaults::Release01);
  ASSERT_TRUE(loaded);
  const auto scene = loaded->protocol.condition("firm")->scene();
  EXPECT_EQ(std::get<engine::InterpolationSpec>(scene.model).curve.back().force, 5.0);
}

TEST(LoadedProtocol, ReadsAFileOnceAndReportsItsProblemsOnce) {
  const auto text = tests::with(
      feeling("mine.json"),
      R"("model": "finite-elements",
        "parameters": { "yield_force_n": 3 })",
      R"("model": "interpolation", "parameters": {"cut": "mine.json"})");
  Shelf shelf{.files = {{"mine.json", tests::with(cutFile(), "10.5", "1")}}};
  EXPECT_EQ(
      errorsIn(text, shelf.finder()),
      Words{"mine.json $.curve[1].travel: the travel does not rise from the point before"});
  EXPECT_EQ(shelf.asked.at("mine.json"), 1);
}

TEST(LoadedProtocol, CountsThePointsOfACutThatIsListedBackwards) {
  const auto text = tests::with(
      feeling("mine.json"),
      R"("model": "finite-elements",
        "parameters": { "yield_force_n": 3 })",
      R"("model": "interpolation", "parameters": {"cut": "mine.json"})");
  Shelf shelf{.files = {{"mine.json", R"({"format": "palpate-cut-1", "name": "c", "title": "C",
          "unit": "travel_unit", "curve": [{"travel": 9, "force_n": 0}, {"travel": 7, "force_n": 4},
          {"travel": 6, "force_n": 2}, {"travel": 5, "force_n": 1}]})"}}};
  EXPECT_EQ(
      errorsIn(text, shelf.finder()),
      Words{"mine.json $.curve[1].travel: the travel does not rise from the point before, nor at 2 "
            "points that follow"});
}

TEST(LoadedProtocol, NamesTheIdOfAFileThatIsMeant) {
  const auto text = tests::with(
      tests::with(tests::usualProtocol(), "realism-cuts", "feel"),
      "\"conditions\": [\n",
      "\"instrument_files\": [\"forms/feel.json\"],\n  \"conditions\": [\n");
  const auto form = std::string(R"({"$schema": "instrument-1.schema.json", "id": "fell",
    "version": "1", "title": "T", "source": {"citation": "c", "licence": "l"}, "languages": ["en"],
    "items": [{"id": "i", "type": "long_text", "text": "How did it feel?"}]})");
  const auto loading = tests::load(text, [&](const std::string& name) {
    return name == "forms/feel.json" ? std::optional(form) : std::nullopt;
  });
  EXPECT_NE(
      loading.describe().find("there is no instrument 'feel'; the file 'forms/feel.json' holds the "
                              "instrument 'fell': write that id here, or change it in the file"),
      std::string::npos)
      << loading.describe();
}

TEST(LoadedProtocol, AsksForNoFileOutsideItsFolder) {
  Shelf shelf;
  for (const std::string name :
       {"../mine.json", "/etc/passwd", "a/../../mine.json", "..", "a/.."}) {
    const Words expected{
        "$.instrument_files[0]: '" + name + "' lies outside the protocol's folder"};
    EXPECT_EQ(errorsIn(naming("[\"" + name + "\"]"), shelf.finder()), expected);
  }
  EXPECT_TRUE(shelf.asked.empty());
}

TEST(LoadedProtocol, ReportsWhyAFileCannotBeRead) {
  const FileFinder broken = [](const std::string&) -> std::optional<std::string> {
    throw base::UserError("The disk is on fire.");
  };
  const auto loading = tests::load(naming(R"(["mine.json"])"), broken);
  ASSERT_EQ(loading.problems.size(), 1U) << loading.describe();
  EXPECT_EQ(base::describe(loading.problems[0].what), "the file 'mine.json' cannot be read");
  EXPECT_EQ(base::describe(loading.problems[0].fix), "The disk is on fire.");
}

TEST(LoadedProtocol, PutsTheNameOfAFileBeforeWhatIsWrongInIt) {
  Shelf shelf{.files = {{"mine.json", "{\"id\": 3"}}};
  const auto said = errorsIn(naming(R"(["mine.json"])"), shelf.finder());
  ASSERT_EQ(said.size(), 1U);
  EXPECT_TRUE(said[0].starts_with("mine.json $")) << said[0];
}

TEST(LoadedProtocol, RefusesItselfAsAnInstrument) {
  const auto text = naming(R"(["me.json"])");
  Shelf shelf{.files = {{"me.json", text}}};
  const auto said = errorsIn(text, shelf.finder());
  ASSERT_FALSE(said.empty());
  for (const auto& words : said) EXPECT_TRUE(words.starts_with("me.json $")) << words;
  EXPECT_EQ(shelf.asked.at("me.json"), 1);
}

TEST(LoadedProtocol, RefusesTwoFilesWithOneIdAlsoUnderTwoSpellings) {
  Shelf shelf{
      .files = {{"mine.json", instrumentFile("mine")}, {"./mine.json", instrumentFile("mine")}}};
  EXPECT_EQ(
      errorsIn(naming(R"(["mine.json", "./mine.json"])"), shelf.finder()),
      Words{"$.instrument_files[1]: './mine.json' holds the instrument 'mine', and so does a file "
            "before it"});
}

TEST(LoadedProtocol, RefusesWhatIsTooLargeOrTooDeepInAFileToo) {
  Shelf shelf{
      .files = {
          {"large.json", std::string(10'000'000, ' ')},
          {"deep.json", std::string(100'000, '[') + std::string(100'000, ']')}}};
  EXPECT_EQ(
      errorsIn(naming(R"(["large.json"])"), shelf.finder()),
      Words{"large.json $: the file is larger than 5 MB"});
  const auto deep = errorsIn(naming(R"(["deep.json"])"), shelf.finder());
  ASSERT_EQ(deep.size(), 1U);
  EXPECT_NE(deep[0].find("nested deeper than 64 levels"), std::string::npos) << deep[0];
  EXPECT_TRUE(deep[0].starts_with("deep.json $")) << deep[0].substr(0, 200);
}

TEST(LoadedProtocol, RefusesWhatIsTooLargeOrTooDeepItself) {
  EXPECT_EQ(errorsIn(std::string(10'000'000, ' ')), Words{"$: the file is larger than 5 MB"});
  const auto deep = errorsIn(std::string(100'000, '['));
  ASSERT_EQ(deep.size(), 1U);
  EXPECT_NE(deep[0].find("nested deeper than 64 levels"), std::string::npos) << deep[0];
}

TEST(LoadedProtocol, PrefersAFileToTheLibrarysInstrumentOfItsName) {
  Shelf shelf{.files = {{"mine.json", instrumentFile("realism-cuts")}}};
  const auto loading = tests::load(naming(R"(["mine.json"])"), shelf.finder());
  ASSERT_TRUE(loading.loaded.has_value()) << loading.describe();
  const auto mine = tests::load(tests::usualProtocol());
  EXPECT_NE(
      loading.loaded->instrument("realism-cuts")->items.size(),
      mine.loaded->instrument("realism-cuts")->items.size());
}

TEST(LoadedProtocol, ComparesNoStatementsOnScalesOfOneLengthThatBeginElsewhere) {
  const auto item = [](const std::string& id, const std::string& lowest) {
    return R"({"id": ")" + id + R"(", "type": "likert", "text": "T", "scale": {"lowest": )" +
           lowest + R"(, "points": 5, "low_label": "no", "high_label": "yes"}})";
  };
  const auto file = [&](const std::string& lowest) {
    return R"({"$schema": "instrument-1.schema.json", "id": "mine", "version": "1", "title": "T",
               "source": {"citation": "c", "licence": "l"}, "languages": ["en"], "items": [)" +
           item("a", "1") + ", " + item("b", lowest) + "]}";
  };
  const auto text = tests::with(naming(R"(["mine.json"])"), "realism-cuts", "mine");
  Shelf alike{.files = {{"mine.json", file("1")}}};
  EXPECT_TRUE(tests::load(text, alike.finder()).loaded.has_value());
  Shelf unlike{.files = {{"mine.json", file("0")}}};
  EXPECT_EQ(
      errorsIn(text, unlike.finder()),
      Words{"$.analysis.families[0].instrument: the Likert items of 'mine' have different scales"});
}

TEST(LoadedProtocol, MakesNoInstrumentOfTheLibrarysSchema) {
  const auto text = tests::with(tests::usualProtocol(), "realism-cuts", "instrument-1.schema");
  const auto said = errorsIn(text);
  ASSERT_FALSE(said.empty());
  EXPECT_EQ(
      said[0],
      "$.phases[1].questionnaires[0].instrument: there is no instrument 'instrument-1.schema'");
}

TEST(LoadedProtocolFile, FindsWhatLiesBesideItWhereverTheProgramRuns) {
  const tests::ScratchFolder folder;
  const auto file = folder.write("study/protocol.json", feeling("cuts/mine.json"));
  folder.write("study/cuts/mine.json", cutFile());
  Problems problems;
  const auto loaded = loadProtocolFile(file, problems);
  ASSERT_TRUE(loaded.has_value()) << describe(problems.all());
  EXPECT_EQ(loaded->files.at(0).name, "cuts/mine.json");
}

TEST(LoadedProtocolFile, IsOfTheLibraryUnderItsNameWithAndWithoutAnEnding) {
  for (const auto* name : {"reaming-hardness", "reaming-hardness.json"}) {
    Problems problems;
    const auto loaded = loadProtocolFile(name, problems);
    ASSERT_TRUE(loaded.has_value()) << describe(problems.all());
    EXPECT_EQ(loaded->protocol.study.id, "reaming-hardness");
  }
}

TEST(LoadedProtocolFile, IsTheOneOnTheDiskWhereOneBearsTheNameOfTheLibrarys) {
  const tests::ScratchFolder folder;
  folder.write("reaming-hardness.json", tests::usualProtocol());
  const auto before = fs::current_path();
  fs::current_path(folder.path());
  Problems problems;
  const auto loaded = loadProtocolFile("reaming-hardness.json", problems);
  fs::current_path(before);
  ASSERT_TRUE(loaded.has_value()) << describe(problems.all());
  EXPECT_EQ(loaded->protocol.study.id, "small");
}

TEST(LoadedProtocolFile, IsTheLibrarysWhereAFolderBearsItsName) {
  const tests::ScratchFolder folder;
  fs::create_directories(folder.path() / "reaming-hardness");
  const auto before = fs::current_path();
  fs::current_path(folder.path());
  Problems problems;
  const auto loaded = loadProtocolFile("reaming-hardness", problems);
  fs::current_path(before);
  EXPECT_TRUE(loaded.has_value()) << describe(problems.all());
}

TEST(LoadedProtocolFile, ReportsThatItIsMissingOrNoFile) {
  const tests::ScratchFolder folder;
  Problems problems;
  EXPECT_THROW(loadProtocolFile(folder / "nothing.json", problems), base::UserError);
  EXPECT_THROW(loadProtocolFile(folder.path().string(), problems), base::UserError);
  const auto large = folder.write("large.json", std::string(10'000'000, ' '));
  EXPECT_THROW(loadProtocolFile(large, problems), base::UserError);
  EXPECT_TRUE(problems.all().empty());
}

TEST(LoadedProtocolFile, ReportsAFileBesideItThatIsTooLarge) {
  const tests::ScratchFolder folder;
  const auto file = folder.write("protocol.json", naming(R"(["large.json"])"));
  folder.write("large.json", std::string(10'000'000, ' '));
  Problems problems;
  EXPECT_FALSE(loadProtocolFile(file, problems).has_value());
  ASSERT_EQ(problems.all().size(), 1U) << describe(problems.all());
  EXPECT_EQ(problems.all()[0].path, "$.instrument_files[0]");
  EXPECT_NE(base::describe(problems.all()[0].fix).find("is larger than 5 MB"), std::string::npos);
}

TEST(LoadedProtocolFile, FollowsNoLinkOutOfItsFolder) {
  const tests::ScratchFolder folder;
  const auto file = folder.write("study/protocol.json", naming(R"(["mine.json"])"));
  const auto said = [&] {
    Problems problems;
    const bool isLoaded = loadProtocolFile(file, problems).has_value();
    return isLoaded ? "" : problems.all().empty() ? "?" : base::describe(problems.all()[0].fix);
  };
  const auto link = folder.path() / "study/mine.json";
  const auto linkTo = [&](const fs::path& target) {
    fs::remove(link);
    fs::create_symlink(target, link);
    return said();
  };
  // control: the same file is read where it lies in the folder, also through a link
  folder.write("study/forms/mine.json", instrumentFile("mine"));
  EXPECT_EQ(linkTo("forms/mine.json"), "");
  EXPECT_EQ(linkTo(folder.path() / "study/forms/mine.json"), "");

  const std::string outside = "It is a link to a file outside the protocol's folder. ";
  folder.write("elsewhere/mine.json", instrumentFile("mine"));
  EXPECT_TRUE(linkTo("../elsewhere/mine.json").starts_with(outside)) << said();
  EXPECT_TRUE(linkTo(folder.path() / "elsewhere/mine.json").starts_with(outside)) << said();
  EXPECT_TRUE(linkTo("/etc/passwd").starts_with(outside)) << said();
  EXPECT_TRUE(linkTo("/dev/zero").starts_with(outside)) << said();
  folder.write("study-2/mine.json", instrumentFile("mine"));  // a folder whose name begins alike
  EXPECT_TRUE(linkTo("../study-2/mine.json").starts_with(outside)) << said();
  fs::remove(link);
  fs::create_directory_symlink(folder.path() / "elsewhere", folder.path() / "study/linked");
  folder.write("study/protocol.json", naming(R"(["linked/mine.json"])"));
  EXPECT_TRUE(said().starts_with(outside)) << said();
}

TEST(LoadedProtocolFile, DoesNotWaitForAPipeBesideIt) {
  const tests::ScratchFolder folder;
  const auto file = folder.write("protocol.json", naming(R"(["mine.json"])"));
  ASSERT_EQ(mkfifo((folder / "mine.json").c_str(), 0600), 0);
  Problems problems;
  EXPECT_FALSE(loadProtocolFile(file, problems).has_value());
  ASSERT_EQ(problems.all().size(), 1U) << describe(problems.all());
  const auto fix = base::describe(problems.all()[0].fix);
  EXPECT_NE(fix.find("is not a file that can be read"), std::string::npos) << fix;
}

/// usualProtocol() with the SUS in place of its questionnaire.
std::string askingTheSus() {
  return tests::with(tests::usualProtocol(), "realism-cuts", "sus");
}

std::string susWords() {
  const auto files = questionnaires::libraryFiles();
  const auto file = std::find_if(
      files.begin(), files.end(), [](const auto& other) { return other.name == "sus.json"; });
  auto instrument = questionnaires::readValidInstrument(file->content, "sus");
  std::string words = questionnaires::wordingTemplate(instrument, "en");
  for (std::size_t at = words.find("\"\""); at != std::string::npos; at = words.find("\"\"")) {
    words.replace(at, 2, "\"words\"");
  }
  return words;
}

TEST(LoadedProtocol, IsRefusedWhereAnInstrumentLacksItsWords) {
  const auto loading = tests::load(askingTheSus());
  EXPECT_FALSE(loading.loaded.has_value());
  ASSERT_EQ(loading.problems.size(), 1U) << loading.describe();
  EXPECT_EQ(loading.problems[0].path, "$.phases[1].questionnaires[0].instrument");
  EXPECT_NE(
      base::describe(loading.problems[0].fix)
          .find("palpate instrument wording sus --language en --out wording/sus/en.json"),
      std::string::npos);
}

TEST(LoadedProtocol, KeepsTheWordingFilesThatItFinds) {
  Shelf shelf{.files = {{"wording/sus/en.json", susWords()}}};
  const auto loading = tests::load(askingTheSus(), shelf.finder());
  ASSERT_TRUE(loading.loaded.has_value()) << loading.describe();
  ASSERT_EQ(ownFilesOf(*loading.loaded), Words{"wording/sus/en.json"});
  EXPECT_EQ(loading.loaded->instrument("sus")->items[0].text.in("en"), "words");
}

TEST(LoadedProtocol, TellsWhatAWordingFileLacks) {
  const auto half = tests::with(susWords(), R"("items/7/text": "words")", R"("items/7/text": "")");
  Shelf shelf{.files = {{"wording/sus/en.json", half}}};
  EXPECT_EQ(
      errorsIn(askingTheSus(), shelf.finder()),
      Words{"wording/sus/en.json $.texts.items/7/text: this text is still empty"});
}

TEST(LoadedProtocol, FindsWordingBesideItsFile) {
  tests::ScratchFolder folder;
  const auto protocol = folder.write("mine.json", askingTheSus());
  Problems problems;
  EXPECT_FALSE(loadProtocolFile(protocol, problems).has_value());
  fs::create_directories(fs::path(protocol).parent_path() / "wording/sus");
  folder.write("wording/sus/en.json", susWords());
  Problems none;
  EXPECT_TRUE(loadProtocolFile(protocol, none).has_value()) << describe(none.all());
}

TEST(LoadedProtocol, WarnsOfAnInstrumentThatMeasuresAChangeAndIsAskedOnce) {
  const auto once = tests::load(tests::with(tests::usualProtocol(), "realism-cuts", "ssq"));
  ASSERT_TRUE(once.loaded.has_value()) << once.describe();
  EXPECT_NE(
      once.describe().find("'ssq' is asked once, and its result is the change"), std::string::npos);
}

}  // namespace loaded_protocol_test
}  // namespace protocols
