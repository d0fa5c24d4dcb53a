// Blanks "[[key]]" in texts for participants, and how a protocol fills them in.
#include <gtest/gtest.h>

#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "protocols/reading/protocol_file.h"
#include "tests/protocols/small_protocol.h"

namespace protocols {
namespace texts_file_test {

using questionnaires::BlankTexts;

LocalizedText english(const std::string& text) {
  return LocalizedText({{"en", text}});
}

LoadedProtocol loaded(const std::string& source) {
  questionnaires::Problems problems;
  auto protocol = loadProtocolFile(source, problems);
  EXPECT_TRUE(protocol) << questionnaires::describe(problems.all());
  return protocol.value_or(LoadedProtocol());
}

LoadedProtocol filled(const LoadedProtocol& protocol, const BlankTexts& texts) {
  questionnaires::Problems problems;
  auto result = withTexts(protocol, texts, problems);
  EXPECT_TRUE(result) << questionnaires::describe(problems.all());
  return result.value_or(LoadedProtocol());
}

TEST(BlankTexts, TakeThePlaceOfBlanksInEachLanguage) {
  const auto protocol = filled(
      loaded("punch-face-validity"),
      {{"institution", LocalizedText({{"en", "Trondheim"}, {"de", "Drontheim"}})},
       {"duration", english("45")}});
  const auto& consent = protocol.instrument("consent-punch-2")->introduction;
  EXPECT_NE(consent.in("en").find("on a computer of Trondheim for "), std::string::npos);
  EXPECT_NE(consent.in("de").find("auf einem Computer von Drontheim"), std::string::npos);
  EXPECT_NE(consent.in("nb").find("datamaskin hos Trondheim"), std::string::npos) << "English";
  EXPECT_NE(consent.in("en").find("takes about 45 minutes"), std::string::npos);
  EXPECT_NE(consent.in("en").find("[[contact]]"), std::string::npos) << "still blank";
}

TEST(BlankTexts, FillEveryShippedProtocolOnce) {
  for (const auto& file : libraryFiles()) {
    const std::string name(file.name);
    if (name.ends_with(".schema.json")) continue;
    const auto protocol = loaded(name.substr(0, name.size() - 5));
    EXPECT_FALSE(unfilledPlaceholdersIn(protocol).empty()) << name << ": templates have blanks";
    BlankTexts texts;
    for (const auto& blank : blanksOf(protocol)) {
      EXPECT_TRUE(blank.text.isEmpty());
      EXPECT_NE(base::describe(blank.title), blank.key) << name << ": it has a title for people";
      texts[blank.key] = english("x");
    }
    EXPECT_EQ(texts.size(), 10U) << name;
    EXPECT_TRUE(unfilledPlaceholdersIn(filled(protocol, texts)).empty()) << name;
    EXPECT_EQ(blanksOf(filled(protocol, texts)).size(), 10U) << "a filled blank can be changed";
  }
}

TEST(BlankTexts, FillBlanksOfTheLaboratorysOwn) {
  auto json = tests::withPhases({R"({"id": "rest", "type": "break", "text": "In [[room]]."})"});
  const auto protocol = filled(*tests::load(json).loaded, {{"room", english("room 4")}});
  EXPECT_EQ(protocol.protocol.phases.back().text.in("en"), "In room 4.");
  EXPECT_EQ(base::describe(blanksOf(protocol).back().title), "room");
}

TEST(BlankTexts, MayNotHaveBlanksThemselves) {
  questionnaires::Problems problems;
  const BlankTexts texts{{"institution", english("[[institution]]")}};
  EXPECT_FALSE(withTexts(loaded("two-devices"), texts, problems));
  EXPECT_NE(
      questionnaires::describe(problems.all()).find("$.texts.institution"), std::string::npos);
}

const BlankTexts kTwo{
    {"a", english("with \"quotes\", {braces} and \\")},
    {"b", LocalizedText({{"de", "zwei"}, {"en", "two"}})}};
const std::string kTwoAsJson =
    R"("texts": {
    "a": "with \"quotes\", {braces} and \\",
    "b": {"de": "zwei", "en": "two"}
  })";

TEST(WithTexts, AddsThemBehindTheLastKey) {
  EXPECT_EQ(
      withTexts("{\n  \"x\": [1, {\"texts\": 2}]\n}\n", kTwo),
      "{\n  \"x\": [1, {\"texts\": 2}],\n  " + kTwoAsJson + "\n}\n");
}

TEST(WithTexts, ReplacesThoseThatAreThere) {
  EXPECT_EQ(
      withTexts(R"({"x": "}", "texts" : {"a": "}\"{"}  , "y": 2.5 })", kTwo),
      R"({"x": "}", )" + kTwoAsJson + R"(  , "y": 2.5 })");
}

TEST(WithTexts, TakesThemAwayWhereNoneAreLeft) {
  EXPECT_EQ(withTexts(R"({"x": 1, "texts": {"a": "b"}, "y": 2})", {}), R"({"x": 1, "y": 2})");
  EXPECT_EQ(withTexts(R"({"texts": {"a": "b"}, "y": 2})", {}), R"({"y": 2})");
  EXPECT_EQ(withTexts(R"({"x": 1, "texts": {"a": "b"}})", {}), R"({"x": 1})");
  EXPECT_EQ(withTexts(R"({"x": 1})", {}), R"({"x": 1})");
}

TEST(WithName, ChangesTheIdAndTheTitleOfTheStudyOnly) {
  EXPECT_EQ(
      withName(
          R"({"id": 1, "study": {"title": "Old", "id": "old", "version": "1"}, "title": "x"})",
          "mine",
          "A \"new\" one"),
      R"({"id": 1, "study": {"title": "A \"new\" one", "id": "mine", "version": "1"}, "title": "x"})");
}

TEST(WithName, MakesEveryShippedProtocolOneThatIsValid) {
  for (const char* name : {"punch-counterbalanced", "reaming-hardness", "two-devices"}) {
    questionnaires::Problems problems;
    const auto own = loadProtocol(
        withName(loaded(name).text, "mine", "My study"),
        [](const std::string&) { return std::nullopt; },
        problems);
    ASSERT_TRUE(own) << questionnaires::describe(problems.all());
    EXPECT_EQ(own->protocol.study.id, "mine");
    EXPECT_EQ(own->protocol.study.title, "My study");
    EXPECT_EQ(own->protocol.conditions.size(), loaded(name).protocol.conditions.size());
  }
}

}  // namespace texts_file_test
}  // namespace protocols
