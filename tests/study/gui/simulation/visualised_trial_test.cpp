// Trials that are seen, and trials that are not, in the windows of a session.
#include <gtest/gtest.h>

#include <QApplication>
#include <QLabel>
#include <QSignalSpy>
#include <QTest>

#include "protocols/anatomy_file.h"
#include "protocols/library.h"
#include "protocols/loaded_protocol.h"
#include "study/export.h"
#include "study/gui/cup_button.h"
#include "study/gui/feel_page.h"
#include "study/gui/operator_window.h"
#include "study/gui/simulation/hip_scene.h"
#include "study/gui/simulation/knee_scene.h"
#include "study/gui/simulation/simulation_view.h"
#include "study/gui/trial_panel.h"
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

  void beginWith(const protocols::LoadedProtocol& loaded, RunMode mode = RunMode::Live) {
    study_.emplace(Study::create(folder_ / "study", loaded, clock_, 7));
    window_.emplace(*study_);
    window_->show();
    window_->enrol(
        {.cohort = loaded.protocol.cohorts.front().id,
         .runMode = mode,
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

TEST_F(VisualisedTrial, ShowsTheKneeThatItsProtocolNames) {
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
  ASSERT_TRUE(loaded) << questionnaires::inWords(problems.all());
  // What the file says later is nothing to the study.
  folder_.write("knee.obj", "o femur\n");
  beginWith(*loaded);
  ASSERT_NE(view(), nullptr);
  const auto* scene = dynamic_cast<simulation::KneeScene*>(&view()->scene());
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

/// The operator's window with the bone in colours.
class BoneInColours : public VisualisedTrial {
 protected:
  CupButton* button() const { return window_->findChild<CupButton*>(); }
  static QWidget* colours() {
    for (auto* widget : QApplication::topLevelWidgets()) {
      if (widget->objectName() == QStringLiteral("cup-window")) return widget;
    }
    return nullptr;
  }
  simulation::HipScene* seen() const { return window_->controller()->seenCup(); }
  static bool isNeutral(const simulation::SphereCloud& cloud) {
    const auto& all = cloud.instances();
    return std::all_of(all.begin(), all.end(), [](const auto& sphere) {
      return sphere.radius == 0.0F || sphere.tint.red >= sphere.tint.blue;
    });
  }
  /// Reams until something is gone.
  void reamALittle() {
    ASSERT_NE(view(), nullptr);
    window_->controller()->beginTrial();
    ASSERT_NE(seen(), nullptr);
    QTest::keyPress(window_->participantWindow()->findChild<FeelPage*>(), Qt::Key_Space);
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return seen()->spheres()->changesSoFar().size() > 50; }, 20'000));
  }
};

TEST_F(BoneInColours, AreThereWhenTheyAreAskedForAndGoWithTheTrial) {
  beginWith(reamingThatIsSeen(), RunMode::Pilot);
  ASSERT_NE(button(), nullptr);
  EXPECT_FALSE(button()->isHidden());
  EXPECT_FALSE(button()->isEnabled());  // nothing is reamed yet
  reamALittle();
  EXPECT_TRUE(QTest::qWaitFor([&] { return button()->isEnabled(); }, 2000));
  EXPECT_EQ(colours(), nullptr);  // nobody has asked
  EXPECT_EQ(window_->findChild<simulation::CupPainter*>(), nullptr);

  button()->click();
  ASSERT_NE(colours(), nullptr);
  auto* painter = colours()->findChild<simulation::CupPainter*>();
  auto* legend = colours()->findChild<simulation::ColourLegend*>();
  const QSignalSpy painted(painter, &simulation::CupPainter::painted);
  EXPECT_TRUE(QTest::qWaitFor([&] { return painted.count() > 1; }, 20'000));
  EXPECT_EQ(legend->marks().size(), 5U);
  EXPECT_TRUE(legend->marks().front().startsWith(QStringLiteral("≤ ")));
  EXPECT_TRUE(legend->accessibleName().contains(QStringLiteral("Pa")));
  tests::photograph(*colours(), QStringLiteral("bone-density"));
  auto* choice = colours()->findChild<QComboBox*>();
  choice->setCurrentIndex(1);
  EXPECT_EQ(legend->marks().back(), QStringLiteral("100"));
  const auto before = painted.count();
  EXPECT_TRUE(QTest::qWaitFor([&] { return painted.count() > before + 2; }, 20'000));
  tests::photograph(*colours(), QStringLiteral("bone-removal"));
  tests::photograph(*window_, QStringLiteral("operator-reaming"));
  // Whatever the operator sees, the participant's stays as it was.
  EXPECT_TRUE(isNeutral(*seen()->spheres()));
  const auto words = colours()->windowTitle() + colours()->accessibleName();
  EXPECT_FALSE(
      words.contains(QString::fromStdString(window_->controller()->session().step().condition)));

  window_->controller()->stop();
  EXPECT_EQ(colours(), nullptr);
  EXPECT_FALSE(button()->isEnabled());
}

TEST_F(BoneInColours, AreGoneWhenTheScreenIsHandedOver) {
  beginWith(reamingThatIsSeen(), RunMode::Pilot);
  reamALittle();
  EXPECT_TRUE(QTest::qWaitFor([&] { return button()->isEnabled(); }, 2000));
  button()->click();
  ASSERT_NE(colours(), nullptr);
  window_->findChild<TrialPanel*>()->closeBone();
  EXPECT_EQ(colours(), nullptr);
  button()->click();
  ASSERT_NE(colours(), nullptr);
  window_.reset();  // with everything that follows it
  EXPECT_EQ(colours(), nullptr);
}

TEST_F(BoneInColours, AreRefusedWhereTheOperatorIsBlindAsWell) {
  beginWith(reamingThatIsSeen());  // live, labels drawn
  ASSERT_NE(view(), nullptr);
  EXPECT_TRUE(whyNoColours(window_->controller()->session()).contains(QStringLiteral("blind")));
  window_->controller()->beginTrial();
  EXPECT_TRUE(QTest::qWaitFor([&] { return seen() != nullptr; }, 2000));
  QTest::qWait(100);
  EXPECT_FALSE(button()->isEnabled());
  EXPECT_EQ(button()->toolTip(), whyNoColours(window_->controller()->session()));
  button()->click();
  EXPECT_EQ(colours(), nullptr);
  window_->controller()->stop();
}

TEST_F(BoneInColours, AreNotOfferedWhereNoBoneIsSeen) {
  begin("punch-face-validity");
  EXPECT_TRUE(button()->isHidden());
  EXPECT_TRUE(whyNoColours(window_->controller()->session()).isEmpty());  // labels are fixed
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
