// The commands for a study: create, simulate, amend, status, backup, export, report.
#include <filesystem>
#include <fstream>
#include <set>
#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "protocols/load_protocol.h"
#include "study/session/session.h"
#include "tests/study/app/palpate_command.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/support/test_data.h"

namespace study_commands_test {

using nlohmann::json;
using tests::expectRefused;
using tests::kTheWorldSaidNo;
using tests::palpate;
using tests::Words;

class StudyCommands : public tests::StudyOfCommands {};

TEST_F(StudyCommands, ExportsOnlyTheRequestedRunMode) {
  const auto study = made("punch-face-validity", 2);
  const std::string out = folder_ / "data";
  expectRefused(
      {"export", study, "--out", out},
      kTheWorldSaidNo,
      {"No participant has taken part", "2 simulated sessions", "--run-mode simulated"});
  EXPECT_FALSE(std::filesystem::exists(out));

  const auto simulated = palpate({"export", study, "--run-mode", "simulated", "--out", out});
  EXPECT_EQ(simulated.status, 0) << simulated.error;
  EXPECT_NE(simulated.out.find("2 simulated sessions, with codes"), std::string::npos);
  const auto readme = tests::contentOf(out + "/README.md");
  EXPECT_NE(readme.find("2 simulated sessions, and no others. Nobody took part"), std::string::npos)
      << readme;
  EXPECT_NE(readme.find("SYNTHETIC"), std::string::npos) << readme;
  EXPECT_EQ(json::parse(tests::contentOf(out + "/codebook.json"))["run_mode"], "simulated");

  const std::string none = folder_ / "none";
  const auto empty = palpate({"export", study, "--run-mode", "pilot", "--out", none});
  EXPECT_NE(empty.out.find("no pilot sessions"), std::string::npos) << empty.out;
  EXPECT_NE(
      tests::contentOf(none + "/README.md").find("No pilot session is in this folder"),
      std::string::npos);
}

TEST_F(StudyCommands, ReportsEarlierSimulatedParticipants) {
  const auto study = made("punch-face-validity", 2);
  const Words fewer{"study", "simulate", study, "--participants", "1"};
  EXPECT_NE(
      palpate(fewer).out.find("2 simulated participants have finished, all of them begun before"),
      std::string::npos);
  const Words more{"study", "simulate", study, "--participants", "11"};
  const auto finished = palpate(more);
  EXPECT_NE(
      finished.out.find("11 simulated participants have finished, 2 of them"), std::string::npos);
  EXPECT_NE(finished.error.find("10 of 11 simulated participants"), std::string::npos);
}

TEST_F(StudyCommands, ReportsAnAmendmentWithoutChanges) {
  const auto study = made("punch-face-validity");
  const auto same = palpate({"study", "amend", study, "--protocol", "punch-face-validity"});
  EXPECT_EQ(same.status, 0) << same.error;
  EXPECT_NE(same.out.find("nothing has changed"), std::string::npos) << same.out;
  const auto other = palpate({"study", "amend", study, "--protocol", "punch-counterbalanced"});
  EXPECT_NE(other.error.find("not another version"), std::string::npos) << other.error;
}

TEST_F(StudyCommands, SavesTheProtocolToBeChangedAndKeepsItsTexts) {
  const auto study = made("punch-face-validity");
  ASSERT_EQ(palpate({"study", "texts", study, "--set", "institution=Our clinic"}).status, 0);
  const std::string file = folder_ / "saved.json";
  const auto saved = palpate({"study", "protocol", study, "--out", file});
  EXPECT_EQ(saved.status, 0) << saved.error;
  EXPECT_NE(saved.out.find("Protocol saved: " + file), std::string::npos) << saved.out;
  const auto same = palpate({"study", "amend", study, "--protocol", file});
  EXPECT_NE(same.out.find("nothing has changed"), std::string::npos) << same.out;
  EXPECT_NE(palpate({"study", "protocol", study, "--out", file}).status, 0) << "it is there";
  // The library's own file has none of the texts.
  auto text = std::string(*protocols::libraryProtocol("punch-face-validity"));
  const std::string title = "\"title\": \"";
  text.insert(text.find(title) + title.size(), "Changed: ");
  const auto changed = folder_.write("changed.json", text);
  const auto amended = palpate({"study", "amend", study, "--protocol", changed});
  EXPECT_EQ(amended.status, 0) << amended.error;
  EXPECT_NE(amended.out.find("Texts kept from the study: institution."), std::string::npos)
      << amended.out;
  const auto texts = palpate({"study", "texts", study}).out;
  EXPECT_NE(texts.find("Our clinic"), std::string::npos) << texts;
}

TEST_F(StudyCommands, SavesTheFilesThatAProtocolNames) {
  tests::MadeStudy study{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
  study.close();
  const auto folder = study.scratch() / "new";
  std::filesystem::create_directories(folder);
  const auto file = folder + "/saved.json";
  const auto saved = palpate({"study", "protocol", study.folder(), "--out", file});
  EXPECT_EQ(saved.status, 0) << saved.error;
  EXPECT_EQ(tests::contentOf(folder + "/everything.json"), tests::everythingInstrument());
  const auto checked = palpate({"protocol", "check", file});
  EXPECT_EQ(checked.status, 0) << checked.out << checked.error;
}

TEST_F(StudyCommands, SaysWhatAnAmendmentChangesForThoseWhoBeganBefore) {
  tests::MadeStudy study;
  study::Session::enrol(*study, {.cohort = "surgeons"});
  study.close();
  auto changed = tests::shortProtocol();
  changed.replace(changed.find("The title of kalman"), 19, "Another");
  const std::string file = study.scratch() / "changed.json";
  std::ofstream(file) << changed;
  const auto amended =
      palpate({"study", "amend", study.folder(), "--protocol", file, "--reason", "typo"});
  EXPECT_NE(
      amended.out.find("1 of 1 participants felt this under another title: kalman"),
      std::string::npos)
      << amended.out << amended.error;
  const auto status = palpate({"study", "status", study.folder()});
  EXPECT_NE(
      status.out.find("live participants have begun with earlier versions only"), std::string::npos)
      << status.out;
}

TEST_F(StudyCommands, KeepsTheColumnsOfStatusApartWhereACodeIsLong) {
  tests::MadeStudy study;
  const std::string code = "a-code-that-is-longer-than-its-column";
  study::Session::enrol(*study, {.cohort = "surgeons", .code = code});
  study.close();
  const auto said = palpate({"study", "status", study.folder()}).out;
  const auto row = said.find(code);
  const auto head = said.find("participant ");
  ASSERT_NE(row, said.npos) << said;
  const auto columnOf = [&](std::size_t from, const std::string& word) {
    return said.find(word, from) - from;
  };
  EXPECT_EQ(columnOf(head, "cohort"), columnOf(row, "surgeons")) << said;
}

TEST_F(StudyCommands, BacksUpAStudyThatVerifiesAfterwards) {
  const auto study = made("punch-face-validity", 2);
  const std::string copy = folder_ / "copy";
  const auto finished = palpate({"study", "backup", study, "--out", copy});
  EXPECT_EQ(finished.status, 0) << finished.error;
  EXPECT_NE(finished.out.find("everything is what was written"), std::string::npos);
  EXPECT_EQ(palpate({"study", "verify", copy}).status, 0);
  EXPECT_EQ(
      palpate({"study", "status", copy, "--json"}).out,
      palpate({"study", "status", study, "--json"}).out);
  expectRefused({"study", "backup", study, "--out", copy}, kTheWorldSaidNo, {"is there already"});
}

TEST_F(StudyCommands, SayThatACopyDoesNotHaveTheParticipantOfACertificate) {
  tests::MadeStudy study;
  const auto copy = study.scratch() / "before";
  const auto certificate = study.scratch() / "certificate.txt";
  study.close();
  EXPECT_EQ(palpate({"study", "backup", study.folder(), "--out", copy}).status, 0);
  study.reopen();
  study::Session::enrol(*study, {.cohort = "surgeons"});
  study.close();
  const auto erased = palpate(
      {"study",
       "erase",
       study.folder(),
       "--participant",
       "P001",
       "--reason",
       "asked",
       "--certificate",
       certificate});
  EXPECT_EQ(erased.status, 0) << erased.out << erased.error;
  const auto repeated = palpate({"study", "erase", copy, "--by", certificate});
  EXPECT_EQ(repeated.status, 0) << repeated.error;
  EXPECT_NE(repeated.out.find("does not have the participant P001"), std::string::npos)
      << repeated.out;
  const auto original = palpate({"study", "erase", study.folder(), "--by", certificate});
  EXPECT_NE(original.out.find("P001 is erased from"), std::string::npos) << original.out;
}

TEST_F(StudyCommands, WritesASelfContainedReport) {
  const auto study = made("punch-face-validity", 3);
  const std::string page = folder_ / "page.html";
  const auto finished = palpate({"report", study, "--run-mode", "simulated", "--out", page});
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto html = tests::contentOf(page);
  for (const auto* loads : {"src=\"http", "href=\"http", "<script", "@import", "url("}) {
    EXPECT_EQ(html.find(loads), std::string::npos) << loads;
  }
  EXPECT_NE(html.find("Simulated"), std::string::npos);
}

TEST_F(StudyCommands, KeepTheFiguresOfTwoStudiesOfOneProtocolApart) {
  const auto study = made("punch-face-validity", 2);
  const std::string page = folder_ / "page.html";
  const std::string figures = folder_ / "figures";
  const auto finished = palpate(
      {"report", study, study, "--run-mode", "simulated", "--out", page, "--figures", figures});
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto filesIn = [](const std::string& folder) {
    std::set<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
      if (entry.is_regular_file()) names.insert(entry.path().filename());
    }
    return names;
  };
  EXPECT_FALSE(filesIn(figures).empty());
  EXPECT_EQ(filesIn(figures), filesIn(figures + "/study-2"));
}

}  // namespace study_commands_test
