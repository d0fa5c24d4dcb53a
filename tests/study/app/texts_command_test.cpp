// The commands that list and fill in the blanks of texts for participants.
#include <filesystem>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/says.h"
#include "tests/support/scratch_folder.h"

namespace texts_command_test {

using nlohmann::json;
using tests::says;

tests::Finished palpate(std::vector<std::string> arguments) {
  arguments.insert(arguments.begin(), tests::program());
  return tests::run(arguments);
}

TEST(TextsCommand, FillsInTheTextsOfAProtocolOnce) {
  const tests::ScratchFolder folder;
  const auto list = palpate({"protocol", "texts", "punch-face-validity"});
  EXPECT_EQ(list.status, 0) << list.error;
  EXPECT_TRUE(says(list.out, "0 of 10 blanks are filled in."));
  EXPECT_TRUE(says(list.out, "a session takes about"));
  const std::string file = folder / "filled.json";
  const auto filled = palpate(
      {"protocol",
       "texts",
       "punch-face-validity",
       "--set",
       "institution=Lab",
       "--set",
       "de:institution=Labor",
       "--out",
       file});
  EXPECT_EQ(filled.status, 0) << filled.error;
  const auto blanks = json::parse(palpate({"protocol", "texts", file, "--json"}).out);
  ASSERT_EQ(blanks.size(), 10U);
  EXPECT_EQ(blanks[0]["key"], "institution");
  EXPECT_EQ(blanks[0]["text"]["de"], "Labor");
  EXPECT_TRUE(blanks[1]["text"].is_null());
  const auto checked = palpate({"protocol", "check", file});
  EXPECT_FALSE(says(checked.out, "[[institution]]")) << checked.out;
  EXPECT_TRUE(says(checked.out, "[[contact]]"));
}

TEST(TextsCommand, RefusesATextForWhichThereIsNoBlank) {
  const tests::ScratchFolder folder;
  const auto refused = palpate(
      {"protocol", "texts", "two-devices", "--set", "nothing=x", "--out", folder / "b.json"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_TRUE(says(refused.error, "'nothing'"));
}

TEST(TextsCommand, RefusesATextInALanguageThatTheProtocolDoesNotHave) {
  const tests::ScratchFolder folder;
  const auto refused = palpate(
      {"protocol",
       "texts",
       "two-devices",
       "--set",
       "pt:contact=A. Autora",
       "--out",
       folder / "b.json"});
  EXPECT_EQ(refused.status, 1);
  EXPECT_TRUE(says(refused.error, "has no texts in 'pt', only in en"));
  EXPECT_FALSE(std::filesystem::exists(folder / "b.json"));
}

TEST(TextsCommand, AmendsAStudy) {
  const tests::ScratchFolder folder;
  const std::string study = folder / "study";
  ASSERT_EQ(palpate({"study", "create", study, "--protocol", "two-devices"}).status, 0);
  const auto filled = palpate({"study", "texts", study, "--set", "contact=A. Author"});
  EXPECT_EQ(filled.status, 0) << filled.error;
  EXPECT_TRUE(says(palpate({"study", "texts", study}).out, "A. Author"));
  EXPECT_EQ(palpate({"study", "verify", study}).status, 0);
}

}  // namespace texts_command_test
