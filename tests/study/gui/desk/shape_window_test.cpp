// The window of the desk that shows a bone or a knee.
#include "study/gui/desk/shape_window.h"

#include <gtest/gtest.h>

#include <QComboBox>
#include <QSignalSpy>
#include <QTest>

#include "haptics/engine/built_in_models.h"
#include "protocols/reading/packing_file.h"
#include "questionnaires/json/problem.h"
#include "study/gui/scene/bone_colours_painter.h"
#include "study/gui/scene/colour_legend.h"
#include "study/gui/scene/knee_scene.h"
#include "study/gui/scene/shapes/knee_anatomy.h"
#include "study/gui/scene/simulation_view.h"
#include "tests/study/gui/participant.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace shape_window_test {

class ShapeWindow : public testing::Test {
 protected:
  QWidget* open(const std::string& path) {
    window_.reset(openShapeWindow(QString::fromStdString(path), nullptr));
    return window_.get();
  }

  tests::ScratchFolder folder_;
  std::unique_ptr<QWidget> window_;
};

TEST_F(ShapeWindow, ShowsABoneColouredByDensity) {
  const auto& bone = *haptics::engine::parametricBone();
  auto* window = open(folder_.write("cup.packing", protocols::packingAsText(bone, {})));
  const auto* legend = window->findChild<scene::ColourLegend*>();
  const QSignalSpy painted(
      window->findChild<scene::BoneColoursPainter*>(), &scene::BoneColoursPainter::painted);
  EXPECT_TRUE(QTest::qWaitFor([&] { return painted.count() > 0; }, 20'000));
  EXPECT_TRUE(legend->accessibleName().contains(QStringLiteral("Pa")));
  EXPECT_EQ(window->findChild<QComboBox*>()->count(), 2);  // no removal, because there is no trial
  EXPECT_EQ(window->windowTitle(), QStringLiteral("cup.packing"));
  tests::photograph(*window, QStringLiteral("bone-at-the-desk"));
}

TEST_F(ShapeWindow, OffersNoDensityColoursWithoutDensities) {
  auto bone = *haptics::engine::parametricBone();
  bone.minimum.clear();
  bone.average.clear();
  bone.maximum.clear();
  auto* window = open(folder_.write("cup.packing", protocols::packingAsText(bone, {})));
  EXPECT_EQ(window->findChild<QComboBox*>()->count(), 1);
  EXPECT_TRUE(window->findChild<scene::ColourLegend*>()->marks().empty());
}

TEST_F(ShapeWindow, ShowsAKneeAsInATrial) {
  auto* window = open(folder_.write("knee.obj", scene::kneeAsObj({})));
  auto* view = dynamic_cast<scene::SimulationView*>(window);
  ASSERT_NE(view, nullptr);
  EXPECT_NE(dynamic_cast<scene::KneeScene*>(&view->scene()), nullptr);
}

TEST_F(ShapeWindow, ShowsTheBuiltInBoneAndKneeWithoutAFile) {
  window_.reset(openBuiltInBone(nullptr));
  EXPECT_NE(window_->findChild<scene::ColourLegend*>(), nullptr);
  EXPECT_EQ(window_->findChild<QComboBox*>()->count(), 2);
  window_.reset(openBuiltInKnee(nullptr));
  auto* view = dynamic_cast<scene::SimulationView*>(window_.get());
  ASSERT_NE(view, nullptr);
  EXPECT_NE(dynamic_cast<scene::KneeScene*>(&view->scene()), nullptr);
}

TEST_F(ShapeWindow, RejectsAnInvalidFile) {
  EXPECT_THROW(open(folder_.write("knee.obj", "o patella\n")), base::UserError);
  EXPECT_THROW(open(folder_.write("cup.packing", "{}")), base::UserError);
  EXPECT_THROW(open(folder_ / "none.obj"), base::UserError);
}

}  // namespace shape_window_test
}  // namespace study::gui
