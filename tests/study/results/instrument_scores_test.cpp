#include "study/results/instrument_scores.h"

#include <cmath>

#include <gtest/gtest.h>

#include "protocols/load_protocol.h"

namespace study {
namespace instrument_scores_test {

/// Two participants of one cohort who fill in forms about two conditions.
class InstrumentScoresTest : public testing::Test {
 protected:
  InstrumentScoresTest() {
    questionnaires::Problems problems;
    loaded_ = *protocols::loadProtocolFile("reaming-hardness", problems);
    for (int i = 1; i <= 2; ++i) {
      storage::SessionRecord session;
      session.id = SessionId{i};
      session.cohort = "students";
      session.participant = "P" + std::to_string(i);
      sessions_[session.id] = session;
    }
    auto& instrument = loaded_.instruments.emplace_back();
    instrument.id = "made-up";
    for (const auto* id : {"a", "b"}) {
      questionnaires::Item item{.id = id, .type = questionnaires::ItemType::Likert};
      item.scale.lowest = 1;
      item.scale.points = 5;
      if (item.id == "b") item.key = -1;
      if (item.id == "a") item.acceptableFrom = 4.0;
      instrument.items.push_back(item);
    }
    instrument.scores.push_back({.id = "total", .items = {"a", "b"}});
  }

  questionnaires::Instrument& instrument() { return loaded_.instruments.back(); }

  void answer(
      int person,
      int step,
      const std::string& condition,
      std::int64_t a,
      std::optional<std::int64_t> b) {
    storage::AnswerRecord record{};
    record.step.visit = {SessionId{person}, step, 1};
    record.step.instrument = "made-up";
    record.step.condition = condition;
    record.answer = {.item = "a", .response = a};
    answers_.push_back(record);
    if (!b) return;
    record.answer = {.item = "b", .response = *b};
    answers_.push_back(record);
  }

  InstrumentSummary summary() const {
    const auto all = summariseInstruments(loaded_, sessions_, answers_);
    EXPECT_EQ(all.size(), 1U);
    return all.empty() ? InstrumentSummary{} : all.front();
  }

  protocols::LoadedProtocol loaded_;
  std::map<SessionId, storage::SessionRecord> sessions_;
  std::vector<storage::AnswerRecord> answers_;
};

TEST_F(InstrumentScoresTest, AreGivenByParticipantAndConditionInTheProtocolsOrder) {
  answer(1, 1, "hardness-100", 5, 1);  // b is reversed: (5 + 5) / 2
  answer(1, 2, "hardness-33", 4, 4);   // (4 + 2) / 2
  answer(1, 3, "hardness-33", 2, 4);   // (2 + 2) / 2; the participant's mean is 2.5
  answer(2, 1, "hardness-33", 4, 1);   // 4.5
  const auto found = summary();
  ASSERT_EQ(found.scores.size(), 2U);
  EXPECT_EQ(found.scores[0].condition, "hardness-33");
  EXPECT_EQ(found.scores[0].values, (std::vector<double>{2.5, 4.5}));
  EXPECT_EQ(*found.scores[0].mean, 3.5);
  EXPECT_NEAR(*found.scores[0].standardDeviation, std::sqrt(2.0), 1e-12);
  // Student: 3.5 -+ 12.7062 (t, 97.5 %, one degree of freedom).
  EXPECT_NEAR(found.scores[0].interval->high, 3.5 + 12.706204736174694, 1e-9);
  EXPECT_EQ(*found.scores[1].mean, 5.0);
  EXPECT_FALSE(found.scores[1].interval);
  EXPECT_EQ(found.forms, 4U);
}

TEST_F(InstrumentScoresTest, CountFormsWithoutAScore) {
  answer(1, 1, "hardness-33", 4, std::nullopt);
  const auto found = summary();
  ASSERT_EQ(found.scores.size(), 1U);
  EXPECT_EQ(found.scores[0].missing, 1U);
  EXPECT_FALSE(found.scores[0].mean);
}

TEST_F(InstrumentScoresTest, AreChangesIfTheInstrumentAsksForThem) {
  instrument().occasions = questionnaires::Occasions::BeforeAndAfter;
  answer(1, 1, "", 2, 4);  // 2
  answer(1, 9, "", 4, 2);  // 4
  answer(2, 1, "", 3, 3);  // 3, answered once only
  const auto found = summary();
  ASSERT_EQ(found.scores.size(), 3U);
  EXPECT_EQ(found.scores[0].occasion, "before");
  EXPECT_EQ(found.scores[0].values, std::vector<double>{2.0});
  EXPECT_EQ(found.scores[1].values, std::vector<double>{4.0});
  EXPECT_EQ(found.scores[2].occasion, "change");
  EXPECT_EQ(found.scores[2].values, std::vector<double>{2.0});
  EXPECT_EQ(found.scores[2].missing, 1U);
}

TEST_F(InstrumentScoresTest, CountParticipantsWhoFindItAcceptable) {
  answer(1, 1, "hardness-33", 5, 1);
  answer(2, 1, "hardness-33", 3, 1);
  const auto found = summary();
  ASSERT_EQ(found.acceptable.size(), 1U);
  EXPECT_EQ(found.acceptable[0].condition, "hardness-33");
  EXPECT_EQ(found.acceptable[0].item.acceptable, 1U);
  EXPECT_EQ(found.acceptable[0].item.answered, 2U);
  // Wilson's interval of 1 of 2 (R: prop.test(1, 2, correct = FALSE)).
  EXPECT_NEAR(found.acceptable[0].interval->low, 0.0945312057, 1e-9);
  EXPECT_NEAR(found.acceptable[0].interval->high, 0.9054687943, 1e-9);
}

}  // namespace instrument_scores_test
}  // namespace study
