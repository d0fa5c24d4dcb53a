#include <unistd.h>

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "questionnaires/json/document.h"
#include "tests/support/complaint.h"
#include "tests/support/scratch_folder.h"

namespace questionnaires {
namespace text_file_test {

std::string complaintAbout(const std::string& path) {
  return tests::complaintOf([&] { readTextFile(path); });
}

TEST(ReadTextFile, GivesEveryByte) {
  const tests::ScratchFolder folder;
  const std::string content("a\r\n\0b\xff", 6);
  EXPECT_EQ(readTextFile(folder.write("a.json", content)), content);
  EXPECT_EQ(readTextFile(folder.write("empty.json", "")), "");
}

TEST(ReadTextFile, SaysThatThereIsNone) {
  const tests::ScratchFolder folder;
  const std::string path = folder / "missing.json";
  EXPECT_EQ(
      complaintAbout(path), "There is no file " + path + ". Check the spelling and the folder.");
}

TEST(ReadTextFile, SaysThatAFolderIsNoFile) {
  const tests::ScratchFolder folder;
  const std::string path = folder.path().string();
  EXPECT_EQ(
      complaintAbout(path),
      path + " is not a file that can be read. Give the name of a text file.");
}

TEST(ReadTextFile, SaysThatItMayNotRead) {
  if (geteuid() == 0) GTEST_SKIP() << "root may read everything";
  const tests::ScratchFolder folder;
  const std::string path = folder.write("secret.json", "{}");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  EXPECT_EQ(
      complaintAbout(path), path + " cannot be opened (Permission denied). Check who may read it.");
}

TEST(ReadTextFile, SaysThatItIsTooLarge) {
  const tests::ScratchFolder folder;
  EXPECT_EQ(readTextFile(folder.write("a", std::string(kLargestFile, ' '))).size(), kLargestFile);
  const std::string path = folder.write("b", std::string(kLargestFile + 1, ' '));
  EXPECT_EQ(
      complaintAbout(path),
      path + " is larger than 5 MB. No researcher's file needs that; is it the right file?");
}

}  // namespace text_file_test
}  // namespace questionnaires
