#include "questionnaires/json/document.h"

#include <string>

#include <gtest/gtest.h>

namespace questionnaires {
namespace document_test {

struct Reading {
  std::optional<Value> value;
  Problems problems;
};

Reading read(std::string_view json) {
  Reading reading;
  reading.value = parseJson(json, reading.problems);
  return reading;
}

bool isFine(const Reading& reading) {
  return reading.value && reading.problems.all().empty();
}

/// The only problem, and nothing readable.
Problem refusal(std::string_view json) {
  const auto reading = read(json);
  EXPECT_FALSE(reading.value.has_value());
  EXPECT_EQ(reading.problems.all().size(), 1U);
  return reading.problems.all().empty() ? Problem{} : reading.problems.all().front();
}

std::string nested(std::size_t levels) {
  return std::string(levels, '[') + std::string(levels, ']');
}

TEST(ParseJson, KeepsTheOrderOfTheFile) {
  const auto reading = read(R"({"z": 1, "a": 2})");
  ASSERT_TRUE(isFine(reading));
  const auto& object = std::get<Value::Object>(reading.value->data);
  EXPECT_EQ(object[0].key, "z");
  EXPECT_EQ(object[1].key, "a");
}

TEST(ParseJson, KeepsLargeWholeNumbersExactly) {
  const auto reading = read("9007199254740993");  // 2^53 + 1
  ASSERT_TRUE(isFine(reading));
  EXPECT_EQ(std::get<std::int64_t>(reading.value->data), 9007199254740993);
}

TEST(ParseJson, DistinguishesFractionsFromWholeNumbers) {
  EXPECT_TRUE(std::holds_alternative<double>(read("1.5").value->data));
  EXPECT_TRUE(std::holds_alternative<double>(read("1.0").value->data));
  EXPECT_TRUE(std::holds_alternative<std::int64_t>(read("1").value->data));
  EXPECT_TRUE(std::holds_alternative<double>(read("18446744073709551615").value->data));
}

TEST(ParseJson, TakesAByteOrderMark) {
  EXPECT_TRUE(isFine(read("\xEF\xBB\xBF{}")));
}

TEST(ParseJson, ReadsSixtyFourLevels) {
  EXPECT_TRUE(isFine(read(nested(64))));
}

TEST(ParseJson, RefusesSixtyFiveLevels) {
  EXPECT_EQ(base::describe(refusal(nested(65)).what), "nested deeper than 64 levels");
}

TEST(ParseJson, SurvivesAHundredThousandLevels) {
  EXPECT_EQ(base::describe(refusal(nested(100'000)).what), "nested deeper than 64 levels");
  std::string objects;
  for (int i = 0; i < 100'000; ++i) objects += R"({"a":)";
  EXPECT_EQ(base::describe(refusal(objects).what), "nested deeper than 64 levels");
}

TEST(ParseJson, ReadsFiveMegabytesAndNoMore) {
  const std::string padding(kLargestFile - 2, ' ');
  EXPECT_TRUE(isFine(read("{" + padding + "}")));
  EXPECT_EQ(base::describe(refusal("{ " + padding + "}").what), "the file is larger than 5 MB");
}

TEST(ParseJson, RefusesListsThatAreFarTooLong) {
  std::string list = "[0";
  for (std::size_t i = 1; i < kMostElements; ++i) list += ",0";
  EXPECT_TRUE(isFine(read(list + "]")));
  EXPECT_EQ(base::describe(refusal(list + ",0]").what), "more than 100000 elements");
}

TEST(ParseJson, NamesEveryKeyThatStandsTwice) {
  const auto reading = read(R"({"a": {"b": 1, "c": 2, "b": 3}, "d": 0, "a": 0})");
  ASSERT_EQ(reading.problems.all().size(), 2U);
  EXPECT_EQ(reading.problems.all()[0].path, "$.a.b");
  EXPECT_EQ(base::describe(reading.problems.all()[0].what), "the key 'b' stands here twice");
  EXPECT_EQ(reading.problems.all()[1].path, "$.a");
}

TEST(ParseJson, LooksThroughManyKeysQuickly) {
  std::string object = "{";
  for (int i = 0; i < 90'000; ++i) object += "\"k" + std::to_string(i) + "\":0,";
  EXPECT_TRUE(isFine(read(object + "\"end\":0}")));
}

TEST(ParseJson, RefusesTheCharacterNul) {
  const auto reading = read(R"({"a": ["x", "a\u0000b"]})");
  ASSERT_EQ(reading.problems.all().size(), 1U);
  EXPECT_EQ(reading.problems.all()[0].path, "$.a[1]");
  EXPECT_EQ(base::describe(reading.problems.all()[0].what), "a text holds the character NUL");
  EXPECT_TRUE(read(R"({"a\u0000": 1})").problems.hasErrors());
}

TEST(ParseJson, RefusesTextsThatAreFarTooLong) {
  EXPECT_TRUE(isFine(read('"' + std::string(kLongestText, 'x') + '"')));
  EXPECT_TRUE(read('"' + std::string(kLongestText + 1, 'x') + '"').problems.hasErrors());
}

TEST(ParseJson, RefusesNumbersThatAreNone) {
  for (const auto* json : {"NaN", "[Infinity]", "-Infinity", "01", "1.", ".5", "+1", "0x10"}) {
    EXPECT_NE(base::describe(refusal(json).what).find("this is not JSON"), std::string::npos)
        << json;
  }
}

TEST(ParseJson, RefusesNumbersThatAreTooLarge) {
  EXPECT_EQ(
      base::describe(refusal("[1e999]").what), "line 1, column 6: the number 1e999 is too large");
  EXPECT_EQ(refusal("[1e999]").path, "$[0]");
}

TEST(ParseJson, RefusesTextsThatAreNoUnicode) {
  const std::vector<std::string> texts{
      R"("\ud800")",           // half a pair
      R"("\udc00\ud800")",     // the halves in the wrong order
      "\"\xC0\xAF\"",          // overlong
      "\"\xED\xA0\x80\"",      // a surrogate in UTF-8
      "\"\xF5\x80\x80\x80\"",  // beyond Unicode
      "\"\xFF\"",
  };
  for (const auto& json : texts) {
    EXPECT_NE(base::describe(refusal(json).what).find("this is not JSON"), std::string::npos)
        << json;
  }
}

TEST(ParseJson, RefusesWhatJsonHasNot) {
  for (const auto* json :
       {"",
        "{} {}",
        "// comment\n{}",
        "{} /* comment */",
        "{'a': 1}",
        "{a: 1}",
        "\"a\nb\"",
        "[",
        "{\"a\"",
        "tru"}) {
    const auto problem = refusal(json);
    EXPECT_NE(base::describe(problem.what).find("this is not JSON"), std::string::npos) << json;
    EXPECT_NE(base::describe(problem.fix).find("JSON has no comments"), std::string::npos) << json;
  }
}

TEST(ParseJson, SaysWhatIsWrongWithCommasQuotesAndEncodings) {
  const std::vector<std::pair<std::string, std::string>> cases{
      {"[1,]", "remove the comma"},
      {"{\"a\":1,}", "remove the comma"},
      {"{\"a\": 1,\n , \"b\": 2}", "remove the comma"},
      {"[1,, 2]", "remove the comma"},
      {"{\"a\": 0,05}", "decimal point"},
      {"{\"a\": \xE2\x80\x9Cx\xE2\x80\x9D}", "straight quotation marks"},
      {"{\"a\": \"H\xFC"
       "fte\"}",
       "save the file as UTF-8"},
      {std::string("\xFF\xFE{\0}\0", 6), "save the file as UTF-8"},
  };
  for (const auto& [json, fix] : cases) {
    EXPECT_NE(base::describe(refusal(json).fix).find(fix), std::string::npos)
        << json << base::describe(refusal(json).fix);
  }
}

TEST(ParseJson, SaysWhereItStopped) {
  const auto problem = refusal("{\n  \"a\": [1,\n    oops]\n}");
  EXPECT_EQ(problem.path, "$.a[0]");
  EXPECT_NE(base::describe(problem.what).find("line 3, column 5"), std::string::npos)
      << base::describe(problem.what);
}

TEST(ParseJson, TakesEveryKindOfText) {
  const auto reading = read(R"("a\tb\n\"\\ \u00e9 \ud83d\ude00 مرحبا")");
  ASSERT_TRUE(isFine(reading));
  EXPECT_EQ(std::get<std::string>(reading.value->data), "a\tb\n\"\\ é 😀 مرحبا");
}

}  // namespace document_test
}  // namespace questionnaires
