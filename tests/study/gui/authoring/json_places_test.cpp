#include "study/gui/authoring/json_places.h"

#include <gtest/gtest.h>

namespace study::gui {
namespace json_places_test {

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

TEST(JsonPlaces, FindsTheLineOfEveryPath) {
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
    EXPECT_EQ(lineOf(kJson, std::string_view(path)), line) << path;
  }
}

TEST(JsonPlaces, FindsWhatIsRoundSomethingThatIsMissing) {
  EXPECT_EQ(lineOf(kJson, std::string_view("$.study.version")), 1);
  EXPECT_EQ(lineOf(kJson, std::string_view("$.phases[1].order.of")), 7);
  EXPECT_EQ(lineOf(kJson, std::string_view("$.phases[12]")), 5);
  EXPECT_EQ(lineOf(kJson, std::string_view("$.analysis")), 0);
}

TEST(JsonPlaces, ReadsAsFarAsThereIsJson) {
  EXPECT_EQ(lineOf("{\n\"a\": 1,\n\"b\": {\n\"c\": ", std::string_view("$.b.c")), 3);
  EXPECT_EQ(lineOf("{\n\"a\" 1", std::string_view("$.b")), 0);
  EXPECT_EQ(lineOf("", std::string_view("$.b")), 0);
  EXPECT_EQ(lineOf("[[[[[\"", std::string_view("$[0][0][0]")), 0);
}

TEST(JsonPlaces, TakesTheLineThatAProblemNames) {
  questionnaires::Problem problem{
      .path = "$.study", .what = "line 4, column 7: this is not JSON", .fix = ""};
  EXPECT_EQ(lineOf(kJson, problem), 3);
  problem.what = "lines are too long";
  EXPECT_EQ(lineOf(kJson, problem), 1);
}

TEST(JsonPlaces, ShowsWhereAnotherFileIsNamed) {
  questionnaires::Problem problem{.path = "two $.items[3]", .what = "no text", .fix = ""};
  EXPECT_EQ(lineOf(kJson, problem), 8);
}

}  // namespace json_places_test
}  // namespace study::gui
