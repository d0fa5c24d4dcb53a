// What the program writes is for its user alone, and is on the disk with its name.
#include <algorithm>
#include <filesystem>
#include <set>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/child_process.h"
#include "tests/support/programs.h"
#include "tests/support/scratch_folder.h"
#include "tests/support/test_data.h"

namespace new_files_test {

namespace fs = std::filesystem;
using Words = std::vector<std::string>;

class NewFiles : public testing::Test {
 protected:
  /// Runs the program where new files are otherwise readable and writable for everybody.
  void palpate(const std::string& words, const std::string& under = {}) {
    const std::string call = "umask 000; cd '" + folder_.path().string() + "' && " + under + " '" +
                             tests::program() + "' " + words;
    const auto finished = tests::run({"sh", "-c", call}, {"ASAN_OPTIONS=detect_leaks=0"});
    ASSERT_EQ(finished.status, 0) << words << "\n" << finished.error;
  }

  void makeStudy() {
    palpate("study create study --protocol punch-counterbalanced --seed 3");
    palpate("study simulate study --participants 1");
  }

  /// Names of what others may read, write or search.
  Words openToOthers() const {
    Words names;
    for (const auto& entry : fs::recursive_directory_iterator(folder_.path())) {
      const auto rights = entry.symlink_status().permissions();
      if ((rights & (fs::perms::group_all | fs::perms::others_all)) != fs::perms::none) {
        names.push_back(entry.path().string());
      }
    }
    return names;
  }

  tests::ScratchFolder folder_;
};

TEST_F(NewFiles, AreForTheirOwnerAlone) {
  makeStudy();
  palpate("export study --run-mode simulated --format bids --out bids");
  palpate("export study --run-mode simulated --traces --unblind --reason test --out unblinded");
  palpate("report study --run-mode simulated --out report.html");
  palpate("study backup study --out copy");
  EXPECT_EQ(openToOthers(), Words{});
  ASSERT_TRUE(fs::exists(folder_ / "copy/study.db"));
  // The same look finds a file that others may read.
  fs::permissions(folder_ / "report.html", fs::perms::others_read, fs::perm_options::add);
  EXPECT_EQ(openToOthers(), Words{folder_ / "report.html"});
}

TEST_F(NewFiles, ThatAreHandedOutAreForTheirOwnerAlone) {
  const auto protocol = (tests::repository() / "tests/attack/one-tissue.json").string();
  palpate("study create study --protocol '" + protocol + "'");
  palpate("study run study --run-mode live", R"(printf 'yes\nno\nAda\n\n3\n' |)");
  palpate("study consent study --participant P001 --out consent.html");
  palpate("study consent study --participant P001 --out consent.pdf");
  palpate("study key export study --reason test --out key.txt");
  palpate("study backup study --out copy");
  palpate("instrument wording sus --language en --out wording.json");
  palpate(
      "study erase study --participant P001 --reason test --also copy "
      "--certificate erased.txt --certificate erased.pdf");
  EXPECT_EQ(openToOthers(), Words{});
  for (const auto* name : {"consent.html", "consent.pdf", "key.txt", "erased.txt", "erased.pdf"}) {
    EXPECT_TRUE(fs::exists(folder_ / name)) << name;
  }
}

/// The calls of the program that make, name or flush files.
class TracedFiles : public NewFiles {
 protected:
  void SetUp() override {
    const auto tried = tests::run({"strace", "-o", folder_ / "tried", "true"});
    if (tried.status != 0) GTEST_SKIP() << "strace is missing or not permitted: " << tried.error;
  }

  Words callsOf(const std::string& words) {
    palpate(
        words, "strace -f -y -s 500 -o calls -e trace=openat,mkdir,rename,fsync,umask,prlimit64");
    Words lines;
    std::istringstream stream(tests::contentOf(folder_ / "calls"));
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
  }

  static std::size_t firstWith(const Words& lines, const std::string& text, std::size_t from = 0) {
    std::size_t i = from;
    while (i < lines.size() && lines[i].find(text) == std::string::npos) ++i;
    return i;
  }
};

TEST_F(TracedFiles, AreForTheirOwnerFromTheFirstByte) {
  for (const std::string words :
       {"study create study --protocol punch-counterbalanced",
        "study simulate study --participants 1",
        "study consent study --participant SIM-001 --out consent.pdf",
        "study key export study --reason test --out key.txt"}) {
    const auto calls = callsOf(words);
    const auto isPrivate = firstWith(calls, "umask(077)");
    ASSERT_LT(isPrivate, calls.size()) << words;
    EXPECT_LT(isPrivate, firstWith(calls, "O_CREAT")) << words;
    EXPECT_LE(isPrivate, firstWith(calls, "mkdir(")) << words;
    EXPECT_EQ(firstWith(calls, "umask(", isPrivate + 1), calls.size()) << words;
  }
}

TEST_F(TracedFiles, AreNoneOfACrashWithNamesInIt) {
  const auto calls = callsOf("study create study --protocol punch-counterbalanced");
  const auto isForbidden = firstWith(calls, "RLIMIT_CORE, {rlim_cur=1,");
  ASSERT_LT(isForbidden, calls.size());
  EXPECT_LT(isForbidden, firstWith(calls, "O_CREAT"));
}

TEST_F(TracedFiles, OfAnExportAreOnTheDiskBeforeItHasItsNameAndItsNameAfterwards) {
  makeStudy();
  const auto calls = callsOf("export study --run-mode simulated --format psych-ds --out out");
  const auto named = firstWith(calls, "rename(");
  ASSERT_LT(named, calls.size());
  std::set<std::string> flushed;
  for (std::size_t i = 0; i < named; ++i) {
    const auto begin = calls[i].find("fsync(");
    if (begin == std::string::npos) continue;
    const auto name = calls[i].substr(calls[i].find('<') + 1);
    flushed.insert(name.substr(0, name.find('>')));
  }
  std::size_t files = 0;
  for (const auto& entry : fs::recursive_directory_iterator(folder_ / "out")) {
    const auto name = fs::relative(entry.path(), folder_ / "out").string();
    const auto isIt = [&](const std::string& path) {
      return path.find(".unfinished-") != std::string::npos && path.size() > name.size() &&
             path.compare(path.size() - name.size() - 1, std::string::npos, "/" + name) == 0;
    };
    EXPECT_TRUE(std::any_of(flushed.begin(), flushed.end(), isIt)) << name;
    ++files;
  }
  EXPECT_GE(files, 8U);
  const auto folder = "<" + fs::canonical(folder_.path()).string() + ">";
  const auto last = firstWith(calls, "fsync(", named);
  ASSERT_LT(last, calls.size()) << "its name is not flushed";
  EXPECT_NE(calls[last].find(folder), std::string::npos) << calls[last];
}

TEST_F(TracedFiles, OfAReportHaveTheirNameOnTheDisk) {
  makeStudy();
  const auto calls = callsOf("report study --run-mode simulated --out report.html");
  const auto made = firstWith(calls, "report.html\", O_WRONLY|O_CREAT");
  ASSERT_LT(made, calls.size());
  const auto folder = "<" + fs::canonical(folder_.path()).string() + ">";
  EXPECT_LT(firstWith(calls, "fsync(", made), firstWith(calls, folder + ")", made + 1));
  EXPECT_LT(firstWith(calls, folder + ")", made + 1), calls.size());
}

}  // namespace new_files_test
