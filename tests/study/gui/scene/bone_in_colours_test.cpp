// The coloured bone, which the operator sees and the participant does not.
#include <algorithm>
#include <cstdlib>

#include <QApplication>
#include <QComboBox>
#include <QSignalSpy>

#include "study/gui/operator/bone_colours_button.h"
#include "study/gui/operator/trial_panel.h"
#include "study/gui/participant/trial_page.h"
#include "tests/study/gui/scene/visualised_trial.h"

namespace study::gui {
namespace bone_in_colours_test {

using tests::reamingThatIsSeen;

/// The operator's window with the coloured bone.
class ColouredBone : public tests::VisualisedTrial {
 protected:
  BoneColoursButton* button() const { return window_->findChild<BoneColoursButton*>(); }
  static QWidget* colours() {
    for (auto* widget : QApplication::topLevelWidgets()) {
      if (widget->objectName() == QStringLiteral("cup-window")) return widget;
    }
    return nullptr;
  }
  scene::HipScene* seen() const { return window_->controller()->visibleHipScene(); }
  static bool isNeutral(const scene::SphereCloud& cloud) {
    const auto& all = cloud.instances();
    return std::all_of(all.begin(), all.end(), [](const auto& sphere) {
      return sphere.radius == 0.0F || sphere.tint.red >= sphere.tint.blue;
    });
  }
  /// Reams until some bone is removed.
  void reamALittle() {
    ASSERT_NE(view(), nullptr);
    window_->controller()->beginTrial();
    ASSERT_NE(seen(), nullptr);
    QTest::keyPress(window_->participantWindow()->findChild<TrialPage*>(), Qt::Key_Space);
    const std::size_t wanted = std::getenv("PALPATE_PICTURES") == nullptr ? 50 : 4000;
    EXPECT_TRUE(
        QTest::qWaitFor([&] { return seen()->spheres()->changesSoFar().size() > wanted; }, 20'000));
  }
};

TEST_F(ColouredBone, OpensOnRequestAndClosesWithTheTrial) {
  beginWith(reamingThatIsSeen(), RunMode::Pilot);
  ASSERT_NE(button(), nullptr);
  EXPECT_FALSE(button()->isHidden());
  EXPECT_FALSE(button()->isEnabled());  // no trial is running yet
  reamALittle();
  EXPECT_TRUE(QTest::qWaitFor([&] { return button()->isEnabled(); }, 2000));
  EXPECT_EQ(colours(), nullptr);  // not requested yet
  EXPECT_EQ(window_->findChild<scene::BoneColoursPainter*>(), nullptr);

  button()->click();
  ASSERT_NE(colours(), nullptr);
  auto* painter = colours()->findChild<scene::BoneColoursPainter*>();
  auto* legend = colours()->findChild<scene::ColourLegend*>();
  const QSignalSpy painted(painter, &scene::BoneColoursPainter::painted);
  EXPECT_TRUE(QTest::qWaitFor([&] { return painted.count() > 1; }, 20'000));
  EXPECT_GE(legend->marks().size(), 3U);
  EXPECT_LE(legend->marks().size(), 6U);
  EXPECT_TRUE(legend->marks().back().startsWith(QStringLiteral("≥ ")));
  EXPECT_TRUE(legend->accessibleName().contains(QStringLiteral("Pa")));
  auto* choice = colours()->findChild<QComboBox*>();
  choice->clearFocus();
  tests::photograph(*colours(), QStringLiteral("bone-density"));
  choice->setCurrentIndex(1);
  EXPECT_EQ(legend->marks().back(), QStringLiteral("100"));
  const auto before = painted.count();
  EXPECT_TRUE(QTest::qWaitFor([&] { return painted.count() > before + 2; }, 20'000));
  tests::photograph(*colours(), QStringLiteral("bone-removal"));
  tests::photograph(*window_, QStringLiteral("operator-reaming"));
  // The participant's view stays neutral.
  EXPECT_TRUE(isNeutral(*seen()->spheres()));
  const auto words = colours()->windowTitle() + colours()->accessibleName();
  EXPECT_FALSE(
      words.contains(QString::fromStdString(window_->controller()->session().step().condition)));

  window_->controller()->stop();
  EXPECT_EQ(colours(), nullptr);
  EXPECT_FALSE(button()->isEnabled());
}

TEST_F(ColouredBone, ClosesOnRequestAndWithTheOperatorWindow) {
  beginWith(reamingThatIsSeen(), RunMode::Pilot);
  reamALittle();
  EXPECT_TRUE(QTest::qWaitFor([&] { return button()->isEnabled(); }, 2000));
  button()->click();
  ASSERT_NE(colours(), nullptr);
  window_->findChild<TrialPanel*>()->closeBoneWindow();
  EXPECT_EQ(colours(), nullptr);
  button()->click();
  ASSERT_NE(colours(), nullptr);
  window_.reset();  // the window that owns it
  EXPECT_EQ(colours(), nullptr);
}

TEST_F(ColouredBone, IsRefusedInADoubleBlindSession) {
  beginWith(reamingThatIsSeen());  // a live session with drawn labels
  ASSERT_NE(view(), nullptr);
  EXPECT_TRUE(
      reasonForNoColours(window_->controller()->session()).contains(QStringLiteral("blind")));
  window_->controller()->beginTrial();
  EXPECT_TRUE(QTest::qWaitFor([&] { return seen() != nullptr; }, 2000));
  QTest::qWait(100);
  EXPECT_FALSE(button()->isEnabled());
  EXPECT_EQ(button()->toolTip(), reasonForNoColours(window_->controller()->session()));
  button()->click();
  EXPECT_EQ(colours(), nullptr);
  window_->controller()->stop();
}

TEST_F(ColouredBone, IsNotOfferedWithoutAVisibleBone) {
  begin("punch-face-validity");
  EXPECT_TRUE(button()->isHidden());
  EXPECT_TRUE(reasonForNoColours(window_->controller()->session()).isEmpty());  // labels are fixed
}

}  // namespace bone_in_colours_test
}  // namespace study::gui
