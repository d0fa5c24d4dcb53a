// A session on the paddle, with its words and units in both windows.
#include <algorithm>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <QLabel>
#include <QTest>

#include "protocols/load_protocol.h"
#include "study/gui/operator/cut_table.h"
#include "study/gui/operator/operator_window.h"
#include "tests/study/gui/participant.h"
#include "tests/study/gui/visible_words.h"
#include "tests/study/known_secret.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace paddle_session_test {

/// The published punch study with the paddle in place of the punch.
protocols::LoadedProtocol protocol(tests::ScratchFolder& folder) {
  questionnaires::Problems problems;
  const auto shipped = protocols::loadProtocolFile("punch-face-validity", problems);
  auto json = nlohmann::ordered_json::parse(shipped->text);
  auto& device = json["devices"][0];
  device["kind"] = "paddle";
  device["max_force_n"] = 5.0;  // a paddle gives less than a punch
  for (auto& condition : json["conditions"]) {
    condition["scene"] = {
        {"device", device["id"]},
        {"model", "finite-elements"},
        {"parameters",
         {{"contact_travel", 10.0}, {"element_stiffness", 0.05}, {"yield_force_n", 2.0}}}};
  }
  for (auto& phase : json["phases"]) phase.erase("visualisation");
  return *protocols::loadProtocolFile(folder.write("protocol.json", json.dump()), problems);
}

bool hasWord(const std::set<QString>& words, const QString& part) {
  return std::any_of(
      words.begin(), words.end(), [&](const QString& word) { return word.contains(part); });
}

TEST(PaddleSession, ShowsPressesAndDegrees) {
  tests::ScratchFolder folder;
  SystemClock clock;
  Study study = Study::create(folder / "study", protocol(folder), clock, 7, tests::knownSecret());
  OperatorWindow window(study);
  tests::Participant participant(window);
  window.show();
  window.enrol({.cohort = "professional", .runMode = RunMode::Pilot, .language = "en", .code = {}});
  participant.goTo(StepKind::Trial);
  participant.look();
  EXPECT_TRUE(hasWord(participant.seen(), QStringLiteral("0 of 3 presses")));
  participant.cut(2);
  participant.look();
  EXPECT_TRUE(hasWord(participant.seen(), QStringLiteral("to press the paddle")));
  EXPECT_TRUE(hasWord(participant.seenByOperator(), QStringLiteral("2 of 3 presses")));
  EXPECT_TRUE(hasWord(participant.seenByOperator(), QStringLiteral("N·°")));
  EXPECT_TRUE(hasWord(participant.seenByOperator(), QStringLiteral("Presses of this trial")));
  const auto* presses = window.findChild<CutTable*>();
  ASSERT_GE(presses->rowCount(), 1);
  EXPECT_EQ(presses->horizontalHeaderItem(1)->text(), QStringLiteral("\n°"));
}

}  // namespace paddle_session_test
}  // namespace study::gui
