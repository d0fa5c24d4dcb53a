// What a laboratory has still to fill in before somebody takes part.
#include <gtest/gtest.h>

#include "protocols/model/loaded_protocol.h"
#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace placeholders_test {

std::vector<Placeholder> placeholdersOf(const std::string& json, const FileFinder& find = {}) {
  const auto loading = tests::load(json, find);
  EXPECT_TRUE(loading.loaded) << loading.describe();
  return loading.loaded ? unfilledPlaceholdersIn(*loading.loaded) : std::vector<Placeholder>();
}

TEST(Placeholders, AreFoundInTheInstrumentsThatAreUsed) {
  const auto found = placeholdersOf(tests::usualProtocol());
  ASSERT_EQ(found.size(), 1U);
  EXPECT_EQ(found[0].where.substr(0, 17), "consent-punch (en");
  EXPECT_EQ(found[0].words, "[[duration]], [[delete_until]], [[institution]], [[contact]]");
}

TEST(Placeholders, AreFoundInEveryLanguageThatAParticipantCanChoose) {
  const std::string phase = R"({"type": "break", "id": "rest", "seconds": 60,
      "text": {"en": "Rest in room 4.", "de": "Ruhen Sie in [[Raum]] aus."}})";
  const auto english = tests::withPhases({phase});
  ASSERT_NE(english.find(R"("en")"), std::string::npos);
  EXPECT_EQ(placeholdersOf(english).size(), 1U) << "nobody can choose German";
  const auto both = tests::with(english, R"("languages": ["en"])", R"("languages": ["en", "de"])");
  const auto found = placeholdersOf(both);
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[0].words, "[[Raum]]");
  EXPECT_TRUE(found[0].where.ends_with("].text (de)")) << found[0].where;
  EXPECT_EQ(found[1].where, "consent-punch (en, de)");
}

TEST(Placeholders, AreFoundInWhatIsChosenFromAsWell) {
  const std::string form = R"({"$schema": "instrument-1.schema.json", "id": "ward", "version": "1",
      "title": {"en": "Ward"}, "source": {"citation": "ours", "licence": "CC0-1.0"},
      "languages": ["en"],
      "items": [{"id": "where", "type": "single_choice", "text": {"en": "Where?"},
                 "options": [{"id": "a", "text": {"en": "[[first ward]]"}},
                             {"id": "b", "text": {"en": "elsewhere"}}]}]})";
  auto json = tests::withPhases({R"({"type": "form", "id": "ward", "instrument": "ward"})"});
  json = tests::with(json, R"("phases": [)", R"("instrument_files": ["ward.json"], "phases": [)");
  const auto found =
      placeholdersOf(json, [&](const std::string&) { return std::optional<std::string>(form); });
  ASSERT_EQ(found.size(), 2U);
  EXPECT_EQ(found[1].where, "ward (en)");
  EXPECT_EQ(found[1].words, "[[first ward]]");
}

}  // namespace placeholders_test
}  // namespace protocols
