#include <gtest/gtest.h>

#include "questionnaires/json/document.h"

namespace questionnaires {
namespace json_lines_test {

constexpr std::string_view kJson = R"({
  "study": {
    "id": "x",
    "title": "a, \"b\" {c}"
  },
  "phases": [
    {"id": "one"},
    {
      "id": "two",
      "sets": {"finite.elements": [1, 2,
        3], "kalman": []}
    }
  ]
})";

struct Case {
  const char* path;
  int line;
};

TEST(JsonLines, FindsTheLineOfEveryPath) {
  for (const auto& [path, line] :
       {Case{"$", 0},
        Case{"$.study", 1},
        Case{"$.study.title", 3},
        Case{"$.phases[0].id", 6},
        Case{"$.phases[1]", 7},
        Case{"$.phases[1].id", 8},
        Case{"$.phases[1].sets.finite.elements", 9},
        Case{"$.phases[1].sets.finite.elements[2]", 10},
        Case{"$.phases[1].sets.kalman", 10}}) {
    EXPECT_EQ(lineOf(kJson, path), line) << path;
  }
}

TEST(JsonLines, FindsWhatIsRoundSomethingThatIsMissing) {
  EXPECT_EQ(lineOf(kJson, "$.study.version"), 1);
  EXPECT_EQ(lineOf(kJson, "$.phases[1].order.of"), 7);
  EXPECT_EQ(lineOf(kJson, "$.phases[12]"), 5);
  EXPECT_EQ(lineOf(kJson, "$.analysis"), 0);
}

TEST(JsonLines, ReadsAsFarAsThereIsJson) {
  EXPECT_EQ(lineOf("{\n\"a\": 1,\n\"b\": {\n\"c\": ", "$.b.c"), 3);
  EXPECT_EQ(lineOf("{\n\"a\" 1", "$.b"), 0);
  EXPECT_EQ(lineOf("", "$.b"), 0);
  EXPECT_EQ(lineOf("[[[[[\"", "$[0][0][0]"), 0);
}

TEST(JsonLines, StandInAProblemWithTheTextItself) {
  Problems problems;
  EXPECT_FALSE(parseJson("{\n\"a\": 1,\n\"b\" 2}", problems));
  ASSERT_EQ(problems.all().size(), 1U);
  EXPECT_EQ(problems.all()[0].line, 2);
}

TEST(JsonLines, AreThoseOfNumbersAtTheEndOfALine) {
  const std::string_view json = "[\n1\n,\n2\n]";
  EXPECT_EQ(lineOf(json, "$[0]"), 1);
  EXPECT_EQ(lineOf(json, "$[1]"), 3);
}

}  // namespace json_lines_test
}  // namespace questionnaires
