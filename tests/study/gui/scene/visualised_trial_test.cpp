// Trials with and without a simulation, in the windows of a session.
#include "tests/study/gui/scene/visualised_trial.h"

#include <QLabel>

#include "protocols/load_protocol.h"
#include "protocols/reading/anatomy_file.h"
#include "study/export/export.h"
#include "study/gui/participant/trial_page.h"
#include "study/gui/scene/hip_scene.h"
#include "study/gui/scene/knee_scene.h"
#include "study/gui/session/trial_view.h"

namespace study::gui {
namespace visualised_trial_test {

using tests::reamingThatIsSeen;
using tests::VisualisedTrial;

TEST_F(VisualisedTrial, ShowsTheSimulationAndSavesItsFrameStatistics) {
  begin("two-devices");
  ASSERT_NE(view(), nullptr);
  EXPECT_TRUE(QTest::qWaitFor([&] { return view()->isVisible(); }, 2000));
  EXPECT_EQ(view()->focusPolicy(), Qt::NoFocus);
  participant_->doStep();
  const auto events = viewEvents();
  ASSERT_EQ(events.size(), 1U);
  EXPECT_EQ(events.front().find("frames 0,"), std::string::npos) << events.front();
  EXPECT_NE(events.front().find("frames "), std::string::npos) << events.front();
  EXPECT_NE(events.front().find("drawn by software rasteriser"), std::string::npos)
      << events.front();
  EXPECT_EQ(events.front().find("latency p50 0.0 ms"), std::string::npos) << events.front();
}

TEST_F(VisualisedTrial, ClosesTheJawInTheKneeWithTheHand) {
  begin("two-devices");
  ASSERT_NE(view(), nullptr);
  auto& controller = *window_->controller();
  controller.beginTrial();
  QTest::keyPress(window_->participantWindow()->findChild<TrialPage*>(), Qt::Key_Space);
  const auto isHalfClosed = [&] { return controller.trialStatus().travel > 5.0; };
  EXPECT_TRUE(QTest::qWaitFor(isHalfClosed, 20'000));
  photographTrial("knee", isHalfClosed);
  controller.stop();
}

TEST_F(VisualisedTrial, HasNoViewInABlockWithoutVisualisation) {
  begin("punch-face-validity");  // its first block is not visualised, its second is
  ASSERT_NE(window_->participantWindow()->findChild<TrialPage*>(), nullptr);
  EXPECT_EQ(view(), nullptr);
  participant_->cut(1);
  EXPECT_EQ(window_->controller()->mesh(), nullptr);
  EXPECT_EQ(window_->controller()->bone(), nullptr);
  EXPECT_EQ(view(), nullptr);
  window_->controller()->stop();
  EXPECT_TRUE(viewEvents().empty());
}

TEST_F(VisualisedTrial, ShowsTheProtocolsKnee) {
  std::string json;
  for (const auto& file : protocols::libraryFiles()) {
    if (file.name == "two-devices.json") json = file.content;
  }
  const std::string device = R"("device": "punch")";
  const std::string knee = R"("anatomy": "knee.obj", )";
  for (auto at = json.find(device); at != std::string::npos;
       at = json.find(device, at + knee.size() + 1)) {
    json.insert(at, knee);
  }
  folder_.write("protocol.json", json);
  folder_.write("knee.obj", "o femur\nv -30 6 0\nv 30 6 0\nv 0 16 4\nvn 0 0 1\nf 1//1 2//1 3//1\n");
  questionnaires::Problems problems;
  const auto loaded = protocols::loadProtocolFile(folder_ / "protocol.json", problems);
  ASSERT_TRUE(loaded) << questionnaires::describe(problems.all());
  // Changing the file later does not change the study.
  folder_.write("knee.obj", "o femur\n");
  beginWith(*loaded);
  ASSERT_NE(view(), nullptr);
  const auto* scene = dynamic_cast<scene::KneeScene*>(&view()->scene());
  ASSERT_NE(scene, nullptr);
  EXPECT_EQ(scene->scene().parts[1].mesh.vertices.size(), 3U);
  window_.reset();
  study_.reset();
  auto again = Study::open(folder_ / "study", clock_);
  const auto& conditions = again.protocol().protocol.conditions;
  const bool isKept = std::any_of(conditions.begin(), conditions.end(), [](const auto& condition) {
    return condition.knee != nullptr && condition.knee->surfaces.size() == 1;
  });
  EXPECT_TRUE(isKept);
}

TEST_F(VisualisedTrial, ShowsTheBoneThatIsReamed) {
  beginWith(reamingThatIsSeen());
  ASSERT_NE(view(), nullptr);
  auto* hip = dynamic_cast<scene::HipScene*>(&view()->scene());
  ASSERT_NE(hip, nullptr);
  ASSERT_NE(hip->spheres(), nullptr);
  const std::size_t whole = hip->spheres()->shown();
  EXPECT_GT(whole, 1000U);
  auto& controller = *window_->controller();
  controller.beginTrial();
  ASSERT_NE(controller.bone(), nullptr);
  QTest::keyPress(window_->participantWindow()->findChild<TrialPage*>(), Qt::Key_Space);
  EXPECT_TRUE(QTest::qWaitFor([&] { return hip->spheres()->shown() != whole; }, 20'000));
  photographTrial("cup", [&] { return hip->spheres()->changesSoFar().size() > 4000; });
  controller.stop();
  ASSERT_EQ(viewEvents().size(), 1U);
  EXPECT_NE(viewEvents().front().find("changes lost 0"), std::string::npos);
}

TEST_F(VisualisedTrial, HasNoViewInAProtocolWithoutVisualisation) {
  begin("reaming-hardness");
  window_->controller()->beginTrial();
  ASSERT_TRUE(window_->controller()->isTrialRunning());
  EXPECT_EQ(view(), nullptr);
  EXPECT_EQ(window_->controller()->bone(), nullptr);
  window_->controller()->stop();
  EXPECT_TRUE(viewEvents().empty());
}

TEST_F(VisualisedTrial, SwitchesTheReamerByAKeyAndKeepsThatAsAnEvent) {
  begin("reaming-hardness");
  window_->controller()->beginTrial();
  auto* page = window_->participantWindow()->findChild<TrialPage*>();
  ASSERT_NE(page, nullptr);
  QTest::keyClick(page, Qt::Key_R);
  QTest::keyClick(page, Qt::Key_R);
  window_->controller()->stop();
  std::vector<std::string> switched;
  for (const auto& event : study_->events().read()) {
    if (event.kind == study::EventKind::SwitchedReamer) switched.push_back(event.detail);
  }
  EXPECT_EQ(switched, (std::vector<std::string>{"off", "on"}));
}

TEST_F(VisualisedTrial, KeepsFrameStatisticsOutOfABlindedExport) {
  begin("two-devices");
  participant_->doStep();
  const auto saysView = [&](bool isBlinded) {
    for (const auto& table : exportTables(*study_, {.isBlinded = isBlinded})) {
      if (table.name != "events") continue;
      if (asCsv(table).find(",view\n") != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(saysView(false));
  EXPECT_FALSE(saysView(true));
}

}  // namespace visualised_trial_test
}  // namespace study::gui
