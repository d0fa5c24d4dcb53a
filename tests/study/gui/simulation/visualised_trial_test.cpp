// Trials that are seen, and trials that are not, in the windows of a session.
#include <gtest/gtest.h>

#include <QLabel>
#include <QTest>

#include "protocols/library.h"
#include "protocols/loaded_protocol.h"
#include "study/export.h"
#include "study/gui/feel_page.h"
#include "study/gui/operator_window.h"
#include "study/gui/simulation/hip_scene.h"
#include "study/gui/simulation/simulation_view.h"
#include "study/gui/trial_view.h"
#include "tests/study/gui/participant.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace {

using simulation::SimulationView;

class VisualisedTrial : public testing::Test {
 protected:
  /// Brings a session of a protocol from the library to its first trial.
  void begin(const std::string& protocol) {
    questionnaires::Problems problems;
    beginWith(*protocols::loadProtocolFile(protocol, problems));
  }

  void beginWith(const protocols::LoadedProtocol& loaded) {
    study_.emplace(Study::create(folder_ / "study", loaded, clock_, 7));
    window_.emplace(*study_);
    window_->show();
    window_->enrol(
        {.cohort = loaded.protocol.cohorts.front().id,
         .runMode = RunMode::Live,
         .language = "en",
         .code = {}});
    const auto& plan = window_->controller()->session().plan();
    int trial = 0;
    while (plan[static_cast<std::size_t>(trial)].kind != StepKind::Trial) ++trial;
    participant_.emplace(*window_);
    participant_->takePart(trial);
  }

  SimulationView* view() const {
    QTest::qWait(100);  // it comes a moment after its page
    return window_->participantWindow()->findChild<SimulationView*>();
  }

  std::vector<std::string> viewEvents() {
    std::vector<std::string> details;
    for (const auto& event : study_->events().read()) {
      if (event.kind == "view") details.push_back(event.detail);
    }
    return details;
  }

  tests::ScratchFolder folder_;
  SystemClock clock_;
  std::optional<Study> study_;
  std::optional<OperatorWindow> window_;
  std::optional<tests::Participant> participant_;
};

TEST_F(VisualisedTrial, IsSeenAndKeepsHowItsFramesWere) {
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

TEST_F(VisualisedTrial, HasNothingOfItWhereItIsFeltAlone) {
  begin("punch-face-validity");  // its second block is seen, its first is not
  ASSERT_NE(window_->participantWindow()->findChild<FeelPage*>(), nullptr);
  EXPECT_EQ(view(), nullptr);
  participant_->cut(1);
  EXPECT_EQ(window_->controller()->mesh(), nullptr);
  EXPECT_EQ(window_->controller()->bone(), nullptr);
  EXPECT_EQ(view(), nullptr);
  window_->controller()->stop();
  EXPECT_TRUE(viewEvents().empty());
}

/// The library's study of reaming, but seen, and of spheres that are taken away.
protocols::LoadedProtocol reamingThatIsSeen() {
  std::string json;
  for (const auto& file : protocols::libraryFiles()) {
    if (file.name == "reaming-hardness.json") json = file.content;
  }
  const auto replace = [&](const std::string& what, const std::string& with) {
    for (std::size_t at = json.find(what); at != std::string::npos;
         at = json.find(what, at + with.size())) {
      json.replace(at, what.size(), with);
    }
  };
  replace(R"("model": "material")", R"("model": "packing", "visualisation": true)");
  questionnaires::Problems problems;
  return *protocols::loadProtocol(
      json, [](const std::string&) { return std::nullopt; }, problems);
}

TEST_F(VisualisedTrial, ShowsTheBoneThatIsReamed) {
  beginWith(reamingThatIsSeen());
  ASSERT_NE(view(), nullptr);
  auto* hip = dynamic_cast<simulation::HipScene*>(&view()->scene());
  ASSERT_NE(hip, nullptr);
  ASSERT_NE(hip->spheres(), nullptr);
  const std::size_t whole = hip->spheres()->shown();
  EXPECT_GT(whole, 1000U);
  auto& controller = *window_->controller();
  controller.beginTrial();
  ASSERT_NE(controller.bone(), nullptr);
  QTest::keyPress(window_->participantWindow()->findChild<FeelPage*>(), Qt::Key_Space);
  EXPECT_TRUE(QTest::qWaitFor([&] { return hip->spheres()->shown() != whole; }, 20'000));
  tests::photograph(*window_->participantWindow(), QStringLiteral("reaming"));
  controller.stop();
  ASSERT_EQ(viewEvents().size(), 1U);
  EXPECT_NE(viewEvents().front().find("changes lost 0"), std::string::npos);
}

TEST_F(VisualisedTrial, IsNoMatterOfAProtocolThatShowsNothing) {
  begin("reaming-hardness");
  window_->controller()->beginTrial();
  ASSERT_TRUE(window_->controller()->isTrialRunning());
  EXPECT_EQ(view(), nullptr);
  EXPECT_EQ(window_->controller()->bone(), nullptr);
  window_->controller()->stop();
  EXPECT_TRUE(viewEvents().empty());
  EXPECT_EQ(window_->findChild<QLabel*>(QStringLiteral("graphics-remark")), nullptr);
}

TEST_F(VisualisedTrial, KeepsItsFramesOutOfABlindedExport) {
  begin("two-devices");
  participant_->doStep();
  const auto saysView = [&](bool isBlinded) {
    for (const auto& table : exportTables(*study_, {.isBlinded = isBlinded})) {
      if (table.name != "events") continue;
      if (asCsv(table).find(",view,") != std::string::npos) return true;
    }
    return false;
  };
  EXPECT_TRUE(saysView(false));
  EXPECT_FALSE(saysView(true));
}

TEST_F(VisualisedTrial, TellsTheOperatorWhereNoCardDraws) {
  begin("two-devices");
  const auto* remark = window_->findChild<QLabel*>(QStringLiteral("graphics-remark"));
  ASSERT_NE(remark, nullptr);
  EXPECT_TRUE(remark->text().contains(QStringLiteral("drawn by the processor")));
  EXPECT_TRUE(remark->toolTip().contains(QStringLiteral("driver")));  // what to do
  // The participant just sees the picture.
  for (const auto* label : window_->participantWindow()->findChildren<QLabel*>()) {
    EXPECT_FALSE(label->text().contains(QStringLiteral("processor")));
  }
}

}  // namespace
}  // namespace study::gui
