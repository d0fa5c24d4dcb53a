#include "study/storage/events_of_release_0_1.h"

#include <gtest/gtest.h>

#include "study/model/messages.h"
#include "study/storage/stored_values.h"

namespace study::storage {
namespace events_of_release_0_1_test {

using base::Message;
using release_0_1::trialReasonsIn;

/// Every message about a trial, and the sentence that release 0.1 wrote.
const std::vector<std::pair<Message, const char*>> kReasons{
    {message("trial.broke_off", "stopped"), "the trial broke off (stopped)"},
    {message("trial.broke_off.fault", "aborted_hardware", "the arm is (still) silent; look"),
     "the trial broke off (aborted_hardware: the arm is (still) silent; look)"},
    {message("trial.samples_kept", 9, 10), "9 of 10 samples were kept"},
    {message("trial.samples_lost", 2), "2 samples were lost"},
    {message("trial.samples_lost.one", 1), "1 sample was lost"},
    {message("trial.device_silent", 2), "the device was silent for 2 ticks"},
    {message("trial.device_silent.one", 1), "the device was silent for 1 tick"},
    {message("trial.wire_faults", 1, 2, 3, 4, 5),
     "on the device's wire 1 were lost, 2 doubled, 3 late, 4 damaged, 5 foreign"},
    {message("trial.clipped", 7), "the device gave less than it was asked for in 7 ticks"},
    {message("trial.clipped.one", 1), "the device gave less than it was asked for in 1 tick"},
    {message("trial.rate", 940.0, 1000.0), "940 of 1000 Hz were reached"},
    {message("trial.late", 30, 4000), "30 of 4000 ticks were late"},
    {message("trial.late.machine", 30, 4000, 2),
     "30 of 4000 ticks were late, 2 of them because the machine itself stood still"},
    {message("trial.cut_off", 0.25, 1.5), "the force was cut off for 0.25 s of 1.50 s"},
    {message("trial.no_force", 0.017), "the scene had no force for 0.017 s"},
    {message("trial.damping", 0.0123, "travel_unit", 5e-05),
     "passivity (b > KT/2) needs 0.0123 N·s/travel_unit of damping, the device has 5e-05, the rest "
     "is the hand's"},
    {message("trial.too_fast", 3, 0.12),
     "the tool was too fast, and the force faded (3×, 0.120 s)"},
    {message("trial.released", 1, 0.12), "the dead-man switch was released (1×, 0.120 s)"},
    {message("trial.lost_beats", 1, 0.0), "the loop lost beats, and the force faded (1×, 0.000 s)"},
    {message("trial.not_finite", 1, 0.001),
     "the scene asked for a force that is no number (1×, 0.001 s)"},
    {message("trial.active", 1, 0.001),
     "the scene gave more energy than it was given: it may have vibrated (1×, 0.001 s)"},
    {message("trial.soft_start", 1, 9.0),
     "the force never came on: the scene asked for too much all along (1×, 9.000 s)"},
};

TEST(TrialReasonsOfRelease01, AreReadFromTheirSentences) {
  std::vector<Message> all;
  std::string sentences;
  for (const auto& [reason, sentence] : kReasons) {
    EXPECT_EQ(trialReasonsIn(sentence), std::vector{reason}) << sentence;
    all.push_back(reason);
    sentences += (sentences.empty() ? "" : "; ") + std::string(sentence);
  }
  EXPECT_EQ(trialReasonsIn(sentences), all);
}

TEST(TrialReasonsOfRelease01, AreKeptVerbatimIfTheyAreUnknown) {
  for (const std::string sentence : {"something else", "2 samples were lost; something else"}) {
    EXPECT_EQ(trialReasonsIn(sentence), std::vector{Message::verbatim(sentence)});
  }
  EXPECT_TRUE(trialReasonsIn("").empty());
}

TEST(AnswersOfRelease01, AreReadWithTheirItem) {
  const auto item = [](const char* detail) {
    return release_0_1::valuesIn(EventKind::Answered, detail);
  };
  EXPECT_EQ(item("1.1 = 4"), (base::NamedArguments{{"item", std::string("1.1")}}));
  EXPECT_EQ(item("1.1 = 'a (kept apart)'"), (base::NamedArguments{{"item", std::string("1.1")}}));
  EXPECT_EQ(
      item("name (kept apart)"),
      (base::NamedArguments{{"item", std::string("name")}, {"kept_apart", std::int64_t{1}}}));
  EXPECT_TRUE(release_0_1::valuesIn(EventKind::Passivity, "K 300, T 0.001 s").empty());
}

TEST(AnswersOfRelease01, AreDescribedAsInThatRelease) {
  const auto said = [](questionnaires::Response response) {
    return release_0_1::detailOf({.item = "a", .response = std::move(response)});
  };
  EXPECT_EQ(said(std::int64_t{4}), "a = 4");
  EXPECT_EQ(said(12.0), "a = 12");
  EXPECT_EQ(said(100000.0), "a = 1e+05");
  EXPECT_EQ(said(std::string("no, 'never'")), "a = 'no, 'never''");
  EXPECT_EQ(said(std::string(201, 'x')).substr(0, 11), "a = sha256:");
}

TEST(StoredMessages, AreReadBackUnchanged) {
  for (const auto& [reason, sentence] : kReasons) {
    EXPECT_EQ(messagesIn(asJson(std::vector{reason})), std::vector{reason}) << sentence;
  }
  EXPECT_EQ(asJson(std::vector<Message>()), "");
  EXPECT_EQ(
      asJson(std::vector{message("trial.late", 30, 4000)}),
      R"([{"code":"trial.late","arguments":[30,4000]}])");
}

TEST(StoredMessages, OfALaterReleaseAreShownWithTheirCode) {
  const auto read = messagesIn(R"([{"code":"trial.new","arguments":[1]}])");
  EXPECT_EQ(read, std::vector{Message::verbatim("trial.new")});
}

TEST(StoredValues, ReadBackExactly) {
  const base::NamedArguments values{
      {"item", std::string("1.1")}, {"point", std::int64_t{4}}, {"number", 0.1}, {"whole", 12.0}};
  EXPECT_EQ(asJson(values), R"({"item":"1.1","point":4,"number":0.1,"whole":12.0})");
  EXPECT_EQ(valuesIn(asJson(values)), values);
  EXPECT_FALSE(valuesIn("[1]").has_value());
  EXPECT_FALSE(valuesIn("{").has_value());
}

}  // namespace events_of_release_0_1_test
}  // namespace study::storage
