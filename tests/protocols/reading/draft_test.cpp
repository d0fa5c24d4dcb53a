// What is wrong is told once; what merely follows from it is not told at all.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "protocols/reading/protocol_file.h"
#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace draft_test {

using Words = std::vector<std::string>;

/// Everything that is said about a protocol that is refused; its files come from @p find.
Words saidAbout(const std::string& json, const FileFinder& find = {}) {
  const auto loading = tests::load(json, find);
  EXPECT_FALSE(loading.loaded.has_value());
  Words said;
  for (const auto& problem : loading.problems)
    said.push_back(problem.path + ": " + base::describe(problem.what));
  return said;
}

/// usualProtocol() that asks "mine" after each condition and names these files.
std::string askingMine(const std::string& files) {
  const auto text = tests::with(tests::usualProtocol(), "realism-cuts", "mine");
  return tests::with(
      text, "\"conditions\": [\n", "\"instrument_files\": " + files + ",\n  \"conditions\": [\n");
}

std::string mine() {
  return tests::with(tests::corpusText("good", "instruments/comfort"), "\"comfort\"", "\"mine\"");
}

TEST(UnvalidatedProtocol, ReportsNoMissingInstrumentIfItsFileIsMissing) {
  EXPECT_EQ(
      saidAbout(askingMine(R"(["mine.json"])")),
      Words{"$.instrument_files[0]: there is no file 'mine.json'"});
}

TEST(UnvalidatedProtocol, ReadsAFileThatIsListedTwiceOnce) {
  const FileFinder find = [](const std::string&) { return std::optional(mine()); };
  EXPECT_EQ(
      saidAbout(askingMine(R"(["mine.json", "mine.json"])"), find),
      Words{"$.instrument_files[1]: 'mine.json' stands in this list twice"});
}

TEST(UnvalidatedProtocol, LooksOnceForAFileThatIsAnInstrumentHereAndACutThere) {
  int asked = 0;
  const FileFinder find = [&](const std::string&) {
    ++asked;
    return std::optional(mine());
  };
  const auto text = tests::with(
      askingMine(R"(["mine.json"])"),
      R"("model": "finite-elements",
        "parameters": { "yield_force_n": 6 })",
      R"("model": "interpolation", "parameters": {"cut": "mine.json"})");
  const auto said = saidAbout(text, find);
  EXPECT_EQ(asked, 1);
  for (const auto& words : said) EXPECT_TRUE(words.starts_with("mine.json $")) << words;
}

TEST(UnvalidatedProtocol, KeepsBackTheWarningsOfAFileWhileSomethingIsWrong) {
  const auto blank = tests::with(mine(), "\"title\": \"", "\"title\": \"[[whose]] ");
  const FileFinder find = [&](const std::string&) { return std::optional(blank); };
  const auto sound = tests::load(askingMine(R"(["mine.json"])"), find);
  EXPECT_NE(sound.describe().find("[[whose]]"), std::string::npos);
  const auto text = tests::with(askingMine(R"(["mine.json"])"), "\"alpha\": 0.05", "\"alpha\": 5");
  EXPECT_EQ(
      saidAbout(text, find), Words{"$.analysis.families[0].alpha: this number is out of range"});
}

TEST(UnvalidatedProtocol, MakesNoModelOfParametersThatCouldNotBeRead) {
  const auto text = tests::with(
      tests::usualProtocol(), R"({ "yield_force_n": 6 })", R"({"tool_position": 3, "colour": 1})");
  EXPECT_EQ(
      saidAbout(text), Words{"$.conditions[1].scene.parameters.colour: unknown key 'colour'"});
}

TEST(UnvalidatedProtocol, ReportsNoMissingBlockIfAPhasesTypeCannotBeRead) {
  const auto text = tests::withPhases(
      {R"({"id": "seen", "type": "blok", "conditions": ["soft", "firm"]})",
       R"({"id": "best", "type": "preference", "instrument": "preference", "block": "seen"})",
       R"({"id": "back", "type": "block", "conditions": ["soft", "firm"], "minimum_cuts": 1,
           "order": {"type": "reversed", "of": "seen"}})"});
  EXPECT_EQ(saidAbout(text), Words{"$.phases[2].type: unknown word 'blok'"});
}

TEST(UnvalidatedProtocol, ReportsNoMissingConditionOrDeviceIfANameCannotBeRead) {
  const auto text = tests::with(tests::usualProtocol(), R"("id": "firm")", R"("id": "fi rm")");
  EXPECT_EQ(saidAbout(text), Words{"$.conditions[1].id: 'fi rm' cannot be an id"});
  const auto other = tests::with(tests::usualProtocol(), R"("kind": "punch")", R"("kind": "pnch")");
  EXPECT_EQ(saidAbout(other), Words{"$.devices[0].kind: there is no kind of device 'pnch'"});
}

}  // namespace draft_test
}  // namespace protocols
