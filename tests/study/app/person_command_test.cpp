// What is stored about one person, who was shown names, and what is to be deleted at the end.
#include <filesystem>

#include "study/session/verification.h"
#include "tests/study/app/palpate_command.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace person_command_test {

using study::EventKind;
using tests::palpate;

/// Two participants who gave a name.
class PersonCommands : public testing::Test {
 protected:
  void SetUp() override {
    takePart("Zaphod Sentinel");
    takePart("Trillian Other");
    study_.close();
  }

  void takePart(const std::string& name) {
    auto session = study::Session::enrol(*study_, {.cohort = "surgeons"});
    tests::walkTo(session, study::StepKind::Form);
    tests::answerStep(session);
    session.record({.item = "name", .response = name, .itemOrder = 2});
    session.record({.item = "line", .response = "said by " + name, .itemOrder = 3});
    session.finishStep();
    tests::walkToTheEnd(session);
  }

  tests::Finished person(const std::string& out, tests::Words more = {}) {
    tests::Words call{
        "study",
        "person",
        study_.folder(),
        "--participant",
        "P001",
        "--out",
        study_.scratch() / out};
    call.insert(call.end(), more.begin(), more.end());
    return palpate(call);
  }

  std::string written(const std::string& file) { return tests::contentOf(study_.scratch() / file); }

  std::vector<study::storage::Event> events(EventKind kind) {
    study_.reopen();
    auto found = study_->events().read(kind);
    study_.close();
    return found;
  }

  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
};

TEST_F(PersonCommands, RecordThatNamesWereShown) {
  const auto shown = palpate({"study", "names", study_.folder()});
  EXPECT_NE(shown.out.find("Zaphod Sentinel"), std::string::npos) << shown.error;
  const auto noted = events(EventKind::ShowedNames);
  ASSERT_EQ(noted.size(), 1U);
  EXPECT_EQ(study::storage::describe(noted[0]), "2 names");
}

TEST_F(PersonCommands, WriteWhatIsStoredAboutOneParticipantAlone) {
  const auto finished = person("out");
  ASSERT_EQ(finished.status, 0) << finished.error;
  const auto page = written("out/person.html");
  for (const std::string said : {"P001", "<td class=\"words\">Zaphod Sentinel", "said by Zaphod"}) {
    EXPECT_NE(page.find(said), std::string::npos) << said;
  }
  const auto all = page + written("out/responses.csv") + written("out/texts.csv") +
                   written("out/sessions.csv") + written("out/wide.csv");
  EXPECT_EQ(all.find("P002"), std::string::npos);
  EXPECT_EQ(all.find("Trillian"), std::string::npos);
  EXPECT_EQ(page.find("interpolation"), std::string::npos) << "which condition was felt";
  const auto noted = events(EventKind::Exported);
  ASSERT_EQ(noted.size(), 1U);
  EXPECT_EQ(std::get<std::string>(*noted[0].value("participant")), "P001");
}

TEST_F(PersonCommands, WriteWhatWasFeltForAReason) {
  const auto finished = person("out", {"--unblind", "--reason", "asked for all of it"});
  ASSERT_EQ(finished.status, 0) << finished.error;
  EXPECT_NE(written("out/person.html").find("interpolation"), std::string::npos);
  EXPECT_NE(written("out/person.html").find("gave_consent"), std::string::npos);
  EXPECT_EQ(written("out/trials.csv").find("P002"), std::string::npos);
  EXPECT_FALSE(std::filesystem::exists(study_.scratch() / "out/statistics.csv"))
      << "it is of all participants";
  EXPECT_EQ(events(EventKind::UnblindedExport).size(), 1U);
}

TEST_F(PersonCommands, HaveTheirFolderListedForThatParticipantsErasure) {
  ASSERT_EQ(person("out").status, 0);
  const auto erase = [&](const std::string& code) {
    return palpate({"study", "erase", study_.folder(), "--participant", code, "--reason", "asked"})
        .out;
  };
  const std::string folder = study_.scratch() / "out";
  EXPECT_EQ(erase("P002").find(folder), std::string::npos);
  EXPECT_NE(erase("P001").find(folder), std::string::npos);
}

TEST_F(PersonCommands, RefuseACodeThatNobodyHas) {
  tests::expectRefused(
      {"study",
       "person",
       study_.folder(),
       "--participant",
       "P009",
       "--out",
       study_.scratch() / "out"},
      tests::kTheWorldSaidNo,
      {"no participant 'P009'", "study status"});
}

TEST_F(PersonCommands, ListWhatIsToBeDeletedAtTheEnd) {
  const std::string copy = study_.scratch() / "copy";
  ASSERT_EQ(palpate({"study", "backup", study_.folder(), "--out", copy}).status, 0);
  const auto listed = palpate({"study", "retention", study_.folder()});
  EXPECT_EQ(listed.status, 0) << listed.error;
  for (const auto& said :
       {study_.folder(), copy, std::string("study-keys"), std::string("not filled in")}) {
    EXPECT_NE(listed.out.find(said), std::string::npos) << said << "\n" << listed.out;
  }
  EXPECT_TRUE(std::filesystem::exists(copy)) << "nothing is deleted";
}

}  // namespace person_command_test
