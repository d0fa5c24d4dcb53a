// Passphrases of names and of a study's key, as they are typed at the terminal.
#include <filesystem>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"

namespace passphrase_test {

const std::string kGull = "a gull on the mast";
const std::string kTern = "a tern on the shore";

class Passphrases : public testing::Test {
 protected:
  /// A command of the program, in the account @p account, with these lines typed.
  tests::Finished typed(
      const std::vector<std::string>& lines,
      std::vector<std::string> command,
      const std::string& account = "account") {
    command.insert(command.begin(), tests::program());
    tests::ChildProcess program(
        command, {"PALPATE_STATION=" + (scratch_ / account)}, tests::ChildProcess::Input::Pipe);
    for (const auto& line : lines) program.say(line);
    return program.finish();
  }

  tests::Finished create(const std::vector<std::string>& lines) {
    return typed(
        lines,
        {"study", "create", study_, "--protocol", "punch-face-validity", "--names-passphrase"});
  }

  static void expectRefused(const tests::Finished& finished, const std::string& words) {
    EXPECT_EQ(finished.status, 1);
    EXPECT_NE(finished.error.find(words), std::string::npos) << finished.error;
  }

  tests::ScratchFolder scratch_;
  std::string study_ = scratch_ / "study";
};

TEST_F(Passphrases, OfNamesAreTypedTwiceBeforeThereIsAStudy) {
  const auto other = create({kGull, kTern});
  expectRefused(other, "The second was another one");
  EXPECT_NE(other.error.find("without it, the names are lost"), std::string::npos) << other.error;
  expectRefused(create({"short", "short"}), "at least 12 characters");
  expectRefused(create({""}), "No passphrase was typed");
  EXPECT_FALSE(std::filesystem::exists(study_));
  EXPECT_EQ(create({kGull, kGull}).status, 0);
  EXPECT_EQ(typed({}, {"study", "verify", study_}).status, 0);
}

TEST_F(Passphrases, OfNamesAreChangedByThePresentOne) {
  ASSERT_EQ(create({kGull, kGull}).status, 0);
  const auto change = [&](const std::vector<std::string>& lines) {
    return typed(
        lines, {"study", "names", study_, "--set-passphrase", "--reason", "an operator left"});
  };
  expectRefused(change({kGull, kTern, kGull}), "The second was another one");
  EXPECT_EQ(change({kGull, kTern, kTern}).status, 0);
  EXPECT_EQ(typed({}, {"study", "verify", study_}).status, 0);
}

TEST_F(Passphrases, OfTheKeyOpenItInAnotherAccountWithinThreeTries) {
  ASSERT_EQ(create({kGull, kGull}).status, 0);
  const std::vector<std::string> set{
      "study", "key", "passphrase", study_, "--reason", "for the second desk"};
  expectRefused(typed({kTern, kGull}, set), "The second was another one");
  ASSERT_EQ(typed({kTern, kTern}, set).status, 0);
  const std::vector<std::string> import{"study", "key", "import", study_};
  expectRefused(typed({kGull, kGull, kGull}, import, "second"), "wrong three times");
  expectRefused(typed({""}, import, "second"), "No passphrase was typed");
  const auto second = typed({kGull, kTern}, import, "second");
  EXPECT_EQ(second.status, 0) << second.error;
  EXPECT_NE(second.error.find("This is not the passphrase"), std::string::npos) << second.error;
  // From then on the account has the key.
  EXPECT_EQ(typed({}, import, "second").status, 0);
}

}  // namespace passphrase_test
