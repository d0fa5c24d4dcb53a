#include <sys/stat.h>

#include <filesystem>
#include <string>

#include <gtest/gtest.h>

#include "haptics/recordings/recording.h"
#include "tests/haptics/recordings/made_recording.h"
#include "tests/support/complaint.h"
#include "tests/support/scratch_folder.h"

namespace haptics::recordings {
namespace recording_file_test {

std::string complaintAbout(const std::filesystem::path& path) {
  return tests::complaintOf([&] { readRecordingFile(path); });
}

TEST(RecordingFile, ReadsWhatTheFileSays) {
  const tests::ScratchFolder folder;
  const std::string text = tests::textOf({});
  const Recording recording = readRecordingFile(folder.write("slow cut - Copy.txt", text));

  EXPECT_EQ(recording.rows, readRecording(text).rows);
  EXPECT_EQ(recording.source, "slow cut - Copy.txt");
}

TEST(RecordingFile, ReportsAFileThatIsNotThere) {
  EXPECT_EQ(
      complaintAbout("/nowhere/cut.txt"),
      "There is no recording '/nowhere/cut.txt': check the name and the folder.");
}

TEST(RecordingFile, ReportsAFolder) {
  const tests::ScratchFolder folder;
  EXPECT_EQ(
      complaintAbout(folder.path()),
      "'" + folder.path().string() + "' is a folder: name one recording in it, a .txt file.");
}

TEST(RecordingFile, ReportsAPipeInsteadOfWaitingForIt) {
  const tests::ScratchFolder folder;
  const std::string pipe = folder / "pipe";
  ASSERT_EQ(mkfifo(pipe.c_str(), 0600), 0);
  EXPECT_EQ(
      complaintAbout(pipe), "'" + pipe + "' is no plain file: copy the recording into one first.");
}

TEST(RecordingFile, ReportsAFileThatIsTooLarge) {
  const tests::ScratchFolder folder;
  const std::string path = folder.write("huge.txt", "");
  std::filesystem::resize_file(path, kLargestRecording + 1);  // a hole: it takes no space
  EXPECT_EQ(
      complaintAbout(path),
      "'" + path +
          "' is larger than 200 MB (200 MB): a recording of the punch has about 1 MB a minute; "
          "check that it is one.");
}

TEST(RecordingFile, ReportsAFileThatMayNotBeRead) {
  const tests::ScratchFolder folder;
  const std::string path = folder.write("locked.txt", "1 2 3 4 5");
  std::filesystem::permissions(path, std::filesystem::perms::none);
  if (complaintAbout(path).empty()) GTEST_SKIP() << "this user may read everything";
  EXPECT_EQ(complaintAbout(path), "'" + path + "' cannot be opened: check that you may read it.");
}

TEST(RecordingFile, CallsAnEmptyFileByItsName) {
  const tests::ScratchFolder folder;
  EXPECT_EQ(
      complaintAbout(folder.write("empty.txt", "")),
      "'empty.txt' is empty: copy or record it again.");
}

}  // namespace recording_file_test
}  // namespace haptics::recordings
