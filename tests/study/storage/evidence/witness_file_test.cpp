#include "study/storage/evidence/witness_file.h"

#include <gtest/gtest.h>

#include "study/model/user_error.h"
#include "study/session/verification.h"
#include "tests/study/made_study.h"
#include "tests/study/storage/sql.h"

namespace study::storage {
namespace witness_file_test {

/// A study of another computer, of which only a witness file is here.
class WitnessFile : public testing::Test {
 protected:
  WitnessFile() {
    study_->note(EventKind::Note, "before");
    writeWitness(study_->database(), file_, "2026-11-23T13:00:00Z");
    study_->note(EventKind::UnblindedExport, "after");
  }

  bool isSound(const std::string& file) {
    const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
    return verify(*study_, {}, {.witness = file}).isSound();
  }
  bool isSound() { return isSound(file_); }

  void edit(const std::string& sql) {
    study_.close();
    tests::Sql(study_.file("study.db")).run(sql);
    study_.reopen();
  }

  tests::MadeStudy study_;
  const std::string file_ = study_.scratch() / "witness.txt";
};

TEST_F(WitnessFile, HasAllSignedHeadsAndOneOfNow) {
  const auto heads = readWitness(file_);
  ASSERT_EQ(heads.size(), 2U);
  EXPECT_EQ(heads[0].head.purpose, "note");
  EXPECT_EQ(heads[1].head.purpose, kWitness);
  EXPECT_EQ(heads[1].head.events, heads[0].head.events + 1);
  EXPECT_THROW(writeWitness(study_->database(), file_, "2026"), StorageError) << "is overwritten";
}

TEST_F(WitnessFile, AgreesWithAStudyThatWentOn) {
  EXPECT_TRUE(isSound());
}

TEST_F(WitnessFile, ShowsThatEventsWereCutOff) {
  edit("DROP TRIGGER an_event_is_never_removed; DELETE FROM event WHERE seq > 2");
  EXPECT_FALSE(isSound());
}

TEST_F(WitnessFile, ShowsThatTheTrailIsAnother) {
  edit("DROP TRIGGER an_event_is_never_changed; UPDATE event SET hash = randomblob(32)");
  EXPECT_FALSE(isSound());
}

TEST_F(WitnessFile, IsNoProofOnceItWasChanged) {
  auto text = tests::contentOf(file_);
  const auto place = text.rfind(" 3 ");
  ASSERT_NE(place, std::string::npos);
  const auto forged = study_.scratch().write("forged.txt", text.replace(place, 3, " 2 "));
  EXPECT_FALSE(isSound(forged));
}

TEST_F(WitnessFile, IsOfOneStudyOnly) {
  tests::MadeStudy other(tests::protocolFrom(tests::shortProtocol()), 2);
  const auto file = other.scratch() / "witness.txt";
  writeWitness(other->database(), file, "2026-11-23T13:00:00Z");
  EXPECT_FALSE(isSound(file));
}

TEST_F(WitnessFile, IsRefusedIfItIsNone) {
  EXPECT_THROW(isSound(study_.scratch() / "missing"), UserError);
  EXPECT_THROW(isSound(study_.scratch().path().string()), UserError);
  EXPECT_THROW(isSound(study_.scratch().write("empty", "")), UserError);
  EXPECT_THROW(isSound(study_.scratch().write("words", "812 events\n")), UserError);
}

}  // namespace witness_file_test
}  // namespace study::storage
