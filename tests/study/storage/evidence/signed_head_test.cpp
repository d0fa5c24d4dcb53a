#include "study/storage/evidence/signed_head.h"

#include <gtest/gtest.h>

#include "study/storage/evidence/station_heads.h"
#include "tests/study/made_study.h"

namespace study::storage {
namespace signed_head_test {

class SignedHeadTest : public testing::Test {
 protected:
  tests::MadeStudy study_;
  const std::filesystem::path folder_ = study_.scratch() / "another";
  const StationStore station_ = StationStore::openOrCreate(folder_);
  const SignedHead head_ = signHead(study_->database(), station_, kWitness, "2026-11-23T13:00:00Z");
};

TEST_F(SignedHeadTest, SaysHowFarTheTrailIs) {
  EXPECT_EQ(head_.events, 1);
  EXPECT_EQ(head_.hash, head_.first);
  EXPECT_EQ(head_.study, study_->uuid());
  EXPECT_EQ("1 events, " + inGroupsOfFour(head_.hash), study_->events().headAsText());
  EXPECT_TRUE(head_.isSigned());
}

TEST_F(SignedHeadTest, IsNotSignedOnceAnythingInItIsAnother) {
  const auto changed = [&](auto change) {
    auto head = head_;
    change(head);
    return head.isSigned();
  };
  EXPECT_FALSE(changed([](auto& head) { ++head.events; }));
  EXPECT_FALSE(changed([](auto& head) { head.hash[0] = head.hash[0] == '0' ? '1' : '0'; }));
  EXPECT_FALSE(changed([](auto& head) { head.first[0] = head.first[0] == '0' ? '1' : '0'; }));
  EXPECT_FALSE(changed([](auto& head) { head.study += "0"; }));
  EXPECT_FALSE(changed([](auto& head) { head.utc = "2026-11-24T13:00:00Z"; }));
  EXPECT_FALSE(changed([](auto& head) { head.purpose = "restored_copy"; }));
  EXPECT_FALSE(changed([](auto& head) { head.signature.clear(); }));
}

TEST_F(SignedHeadTest, IsOneLine) {
  std::string rest;
  const auto read = headIn(head_.asLine() + " /a folder/study", &rest);
  ASSERT_TRUE(read);
  EXPECT_TRUE(read->isSigned());
  EXPECT_EQ(read->asLine(), head_.asLine());
  EXPECT_EQ(rest, "/a folder/study");
  for (const std::string wrong : {"", "palpate-head-1", "palpate-head-2 a b 1 c d e f g", "x"}) {
    EXPECT_FALSE(headIn(wrong)) << wrong;
  }
  auto words = head_.asLine();
  words.replace(words.find(" 1 "), 3, " one ");
  EXPECT_FALSE(headIn(words));
}

TEST_F(SignedHeadTest, IsNotedByItsStation) {
  EXPECT_TRUE(readRecordedHeads(station_, study_->uuid()).heads.empty());
  recordHead(station_, head_, "/a folder/study\nwith a line");
  const auto noted = readRecordedHeads(station_, study_->uuid()).heads;
  ASSERT_EQ(noted.size(), 1U);
  EXPECT_EQ(noted[0].head.asLine(), head_.asLine());
  EXPECT_EQ(noted[0].folder, "/a folder/study?with a line");
}

TEST_F(SignedHeadTest, IsLeftOutOfAListThatWasChanged) {
  recordHead(station_, head_, "/study");
  auto forged = head_;
  forged.events = 2;
  station_.append("heads-" + study_->uuid(), forged.asLine());
  station_.append("heads-" + study_->uuid(), head_.asLine().substr(0, 90));
  const auto noted = readRecordedHeads(station_, study_->uuid());
  EXPECT_EQ(noted.heads.size(), 1U);
  EXPECT_EQ(noted.unsoundLines, 2U);
}

TEST_F(SignedHeadTest, LeadsToNoFileOutsideOfTheStation) {
  auto head = head_;
  head.study = "../outside";
  recordHead(station_, head, "/study");
  EXPECT_FALSE(std::filesystem::exists(study_.scratch() / "heads-" + "../outside"));
  EXPECT_FALSE(std::filesystem::exists(study_.scratch() / "outside"));
}

}  // namespace signed_head_test
}  // namespace study::storage
