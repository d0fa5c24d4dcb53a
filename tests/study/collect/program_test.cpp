// The program palpate-collect, as an administrator and a person at the desk call it.
#include <filesystem>

#include <fmt/format.h>

#include "tests/study/collect/collected_study_at.h"
#include "tests/support/child_process.h"

namespace program_test {

class CollectProgram : public tests::CollectTest {
 protected:
  /// What it prints, with its errors.
  std::string call(std::vector<std::string> words, int status = 0) {
    const auto folder = std::filesystem::read_symlink("/proc/self/exe").parent_path();
    words.insert(words.begin(), folder / "palpate-collect");
    const auto finished = tests::run(
        words,
        {"PALPATE_SERVER=" + postgres().server(database()),
         "PALPATE_STATION=" + (scratch_ / "account")});
    EXPECT_EQ(finished.status, status) << words.at(1) << ": " << finished.error;
    return finished.out + finished.error;
  }

  static void expectWords(const std::string& said, const std::string& words) {
    EXPECT_NE(said.find(words), std::string::npos) << said;
  }
};

TEST_F(CollectProgram, EnrolsByAMarkAndShowsWhatWasRefused) {
  const auto protocol = scratch_.write("protocol.json", tests::shortProtocol());
  expectWords(call({"init", "--study", "realism", "--protocol", protocol}), "is on the server");
  auto key = call({"key"});
  key.pop_back();
  const auto file = scratch_ / "oslo.enrol";
  const auto said =
      call({"init", "--study", "realism", "--station", file, "--site", "oslo", "--key", key});
  const std::string sign = "telephone: ";
  expectWords(said, sign);
  const auto mark = said.substr(said.find(sign) + sign.size(), 24);
  expectWords(
      call({"join", file, folderOf("oslo"), "--mark", "0000 0000 0000 0000 0000"}, 1),
      "has the mark " + mark);
  expectWords(call({"join", file, folderOf("oslo"), "--mark", mark}), "is ready");
  // Over the socket every role is let in.
  const auto way = fmt::format(
      "host={} port={} dbname={}", postgres().folder().string(), postgres().port(), database());
  expectWords(call({"push", folderOf("oslo"), "--server", way}), "new events sent");
  expectWords(
      call({"revoke", "--study", "realism", "--station", "oslo", "--reason", "stolen"}), "");
  expectWords(call({"push", folderOf("oslo"), "--server", way}, 1), "stolen");
  const auto status = call({"status"});
  expectWords(status, "Refused, the newest first");
  expectWords(status, "station_oslo");
  expectWords(status, "revoked: stolen");
}

TEST_F(CollectProgram, SaysWhatTheServersLogIsMissing) {
  const auto protocol = scratch_.write("protocol.json", tests::shortProtocol());
  const std::vector<std::string> words{"init", "--study", "realism", "--protocol", protocol};
  EXPECT_EQ(call(words).find("log_line_prefix"), std::string::npos);
  admin().execute("ALTER DATABASE " + database() + " SET log_min_error_statement = 'panic'");
  expectWords(call(words), "log_line_prefix");
}

}  // namespace program_test
