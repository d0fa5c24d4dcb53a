// The command for questionnaires: the library, scoring keys, and wording files.
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/says.h"
#include "tests/support/scratch_folder.h"

namespace instrument_commands_test {

using Words = std::vector<std::string>;
using tests::says;

tests::Finished instrument(Words arguments) {
  arguments.insert(arguments.begin(), {tests::program(), "instrument"});
  return tests::run(arguments);
}

/// @p json with words between every two empty quotation marks.
std::string filledIn(std::string json) {
  for (auto at = json.find("\"\""); at != std::string::npos; at = json.find("\"\"", at)) {
    json.replace(at, 2, "\"words\"");
  }
  return json;
}

TEST(InstrumentCommands, ListTheLibraryAndMissingWordings) {
  const auto finished = instrument({"list"});
  EXPECT_EQ(finished.status, 0);
  EXPECT_TRUE(says(finished.out, "nasa-tlx-weighted"));
  EXPECT_TRUE(says(finished.out, "Being there (its words come from a wording file)"));
  EXPECT_FALSE(says(finished.out, ".schema"));
}

TEST(InstrumentCommands, ShowTheScoringKey) {
  const auto sus = instrument({"keys", "sus"});
  EXPECT_EQ(sus.status, 0);
  EXPECT_TRUE(says(sus.out, "reversed: x counts 6 - x"));
  EXPECT_TRUE(says(sus.out, "(sum(4, 10) - 2) * 12.5"));
  EXPECT_TRUE(says(sus.out, "at least 5 answers are needed, a missing one counts as 3"));
  const auto ssq = instrument({"keys", "ssq"}).out;
  EXPECT_TRUE(says(ssq, "weighted sum(2 * 1-general-discomfort, 2-fatigue"));
  EXPECT_TRUE(says(ssq, "* 3.74"));
  EXPECT_TRUE(says(ssq, "after - before"));
  EXPECT_TRUE(says(instrument({"keys", "ueq"}).out, "within 3 of 6 scores lie more than 3 apart"));
  EXPECT_TRUE(says(instrument({"keys", "simulator-realism"}).out, "acceptable from 7"));
  EXPECT_EQ(instrument({"keys", "debrief"}).out, "Nothing is scored here.\n");
}

TEST(InstrumentCommands, RefuseAnInstrumentWithoutItsWording) {
  const tests::ScratchFolder folder;
  const Words check{"check", "sus", "--folder", folder.path().string()};
  const auto before = instrument(check);
  EXPECT_EQ(before.status, 1);
  EXPECT_TRUE(says(before.out, "palpate instrument wording sus --language en --out wording/sus"));

  const std::string file = folder / "wording/sus/en.json";
  EXPECT_EQ(instrument({"wording", "sus", "--out", file}).status, 0);
  const auto empty = instrument(check);
  EXPECT_EQ(empty.status, 1);
  EXPECT_TRUE(says(empty.out, "wording/sus/en.json $.source: this text is empty"));

  folder.write("wording/sus/en.json", filledIn(tests::contentOf(file)));
  const auto after = instrument(check);
  EXPECT_EQ(after.status, 0);
  EXPECT_EQ(after.out, "sus can be asked in: en.\n");
}

TEST(InstrumentCommands, NeverOverwriteAWordingFile) {
  const tests::ScratchFolder folder;
  const auto file = folder.write("en.json", "mine");
  const auto finished = instrument({"wording", "ipq", "--out", file});
  EXPECT_EQ(finished.status, 1);
  EXPECT_TRUE(says(finished.error, "Nothing is ever overwritten"));
  EXPECT_EQ(tests::contentOf(file), "mine");
}

TEST(InstrumentCommands, PrintAWordingTemplateOrReportThatNoneIsNeeded) {
  EXPECT_EQ(instrument({"wording", "ipq", "--language", "de"}).out.rfind("{\n", 0), 0U);
  EXPECT_EQ(instrument({"wording", "ueq-s"}).out, "ueq-s has all its words in 'en' already.\n");
  EXPECT_EQ(instrument({"wording", "ipq", "--language", "English"}).status, 2);
  EXPECT_EQ(instrument({"wording", "nothing-of-the-kind"}).status, 1);
}

}  // namespace instrument_commands_test
