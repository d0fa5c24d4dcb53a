// The commands for protocols: the library, problems, orders.
#include <algorithm>
#include <string>

#include <gtest/gtest.h>

#include "tests/study/app/palpate_command.h"

namespace protocol_commands_test {

using tests::expectRefused;
using tests::kTheWorldSaidNo;
using tests::linesOf;
using tests::palpate;

class ProtocolCommands : public tests::StudyOfCommands {};

TEST_F(ProtocolCommands, ListsProtocolsThatOtherCommandsTakeByName) {
  const auto listed = palpate({"protocol", "list"});
  EXPECT_EQ(listed.status, 0) << listed.error;
  const auto lines = linesOf(listed.out);
  ASSERT_EQ(lines.size(), 5U) << listed.out;
  for (const auto& line : lines) {
    const auto name = line.substr(0, line.find(' '));
    const auto checked = palpate({"protocol", "check", name}).out;
    const auto title = line.substr(line.find("conditions") + std::string("conditions  ").size());
    EXPECT_NE(checked.find(name + " is valid: \"" + title + "\""), std::string::npos) << checked;
  }
}

TEST_F(ProtocolCommands, NamesTheListWhereANameIsUnknown) {
  expectRefused(
      {"protocol", "check", "punch"}, kTheWorldSaidNo, {"no protocol punch", "protocol list"});
}

TEST_F(ProtocolCommands, ReportsAllProblemsOfAProtocolWithTheirPlaces) {
  const auto file = folder_.write("bad.json", R"({"$schema": "protocol-1.schema.json",
      "study": {"id": "a b", "title": "", "versoin": "1"}})");
  const auto finished = palpate({"protocol", "check", file});
  EXPECT_EQ(finished.status, kTheWorldSaidNo);
  for (const auto* place : {"$.study.id", "$.study.title", "$.study.versoin", "'conditions'"}) {
    EXPECT_NE((finished.out + finished.error).find(place), std::string::npos) << place;
  }
}

TEST_F(ProtocolCommands, ShowsTheOrderOfEveryParticipant) {
  const auto finished =
      palpate({"protocol", "orders", "reaming-hardness", "--participants", "4", "--csv"});
  EXPECT_EQ(finished.status, 0);
  EXPECT_GE(linesOf(finished.out).size(), 1U + 3U * 4U * 4U);  // cohorts, people, levels
  const auto fixed = palpate({"protocol", "orders", "punch-face-validity", "--participants", "12"});
  const auto lines = linesOf(fixed.out);
  const auto isOrder = [](const std::string& line) {
    return line.find("  12 ×  round-") != std::string::npos;
  };
  EXPECT_EQ(std::count_if(lines.begin(), lines.end(), isOrder), 2 * 2) << fixed.out;
  EXPECT_NE(fixed.out.find("[1, 2, 3, 4, 5, 6, 7, 8, …]"), std::string::npos);
  EXPECT_LT(lines.size(), 20U) << fixed.out;
  const auto words = palpate({"protocol", "orders", "reaming-hardness", "--participants", "5"});
  EXPECT_NE(words.out.find("do NOT balance it"), std::string::npos);
}

}  // namespace protocol_commands_test
