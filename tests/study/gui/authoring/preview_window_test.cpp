#include "study/gui/authoring/preview_window.h"

#include <algorithm>

#include <gtest/gtest.h>

#include <QFileInfo>
#include <QScreen>
#include <QTest>

#include "protocols/load_protocol.h"
#include "study/gui/participant/column.h"
#include "study/gui/widgets/theme.h"
#include "tests/study/gui/participant.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/gui/visible_words.h"

namespace study::gui {
namespace preview_window_test {

protocols::LoadedProtocol shipped(const char* name) {
  questionnaires::Problems problems;
  return *protocols::loadProtocolFile(name, problems);
}

TEST(PreviewWindow, ShowsEveryPageInItsPlaceAndKeepsNothing) {
  QString folder;
  {
    PreviewWindow preview(shipped("two-devices"));
    preview.show();
    folder = preview.folder();
    EXPECT_TRUE(QFileInfo::exists(folder));
    const auto& plan = preview.controller().session().plan();
    auto* steps = preview.findChild<QListWidget*>(QStringLiteral("steps"));
    ASSERT_EQ(steps->count(), static_cast<int>(plan.size()) + 1) << "and the end";
    for (int step = 0; step < steps->count(); ++step) {
      steps->setCurrentRow(step);
      EXPECT_EQ(preview.controller().session().stepIndex(), step);
      EXPECT_TRUE(preview.page().isVisible());
      QCoreApplication::processEvents();
      tests::keepPicture(preview.page().grab().toImage(), QStringLiteral("preview-%1").arg(step));
    }
    EXPECT_TRUE(preview.controller().session().isOver());
    steps->setCurrentRow(1);
    EXPECT_EQ(preview.controller().session().stepIndex(), 1) << "back again";
  }
  EXPECT_FALSE(QFileInfo::exists(folder));
}

TEST(PreviewWindow, HasTheLanguageAndTheSizeThatAreChosen) {
  PreviewWindow preview(shipped("punch-face-validity"));
  preview.show();
  auto* languages = preview.findChild<QComboBox*>(QStringLiteral("language"));
  auto* sizes = preview.findChild<QComboBox*>(QStringLiteral("size"));
  languages->setCurrentIndex(languages->findData(QStringLiteral("de")));
  sizes->setCurrentIndex(sizes->findData(QSize(1280, 720)));
  preview.resize(2000, 1000);
  QCoreApplication::processEvents();
  EXPECT_EQ(preview.page().size(), QSize(1280, 720));
  EXPECT_NE(tests::buttonSaying(&preview.page(), QStringLiteral("Weiter")), nullptr);
  preview.findChild<QListWidget*>(QStringLiteral("steps"))->setCurrentRow(1);
  EXPECT_EQ(preview.controller().session().language(), "de");
  EXPECT_EQ(preview.page().size(), QSize(1280, 720));
  tests::photographInAllThemes(preview, QStringLiteral("preview"));
}

TEST(PreviewWindow, BeginsWithTheParticipantsScreenAndShowsALargeOneWhole) {
  PreviewWindow preview(shipped("punch-face-validity"));
  preview.resize(1366, 768);
  preview.show();
  QCoreApplication::processEvents();
  const auto* place = preview.findChild<QScrollArea*>();
  auto* sizes = preview.findChild<QComboBox*>(QStringLiteral("size"));
  EXPECT_EQ(sizes->currentData().toSize(), QGuiApplication::primaryScreen()->size());
  const QSize wide(1920, 1080);
  sizes->setCurrentIndex(sizes->findData(wide));
  QCoreApplication::processEvents();
  EXPECT_EQ(preview.page().size(), wide.scaled(place->viewport()->size(), Qt::KeepAspectRatio));
  const double ratio = 1.0 * preview.page().width() / wide.width();
  constexpr int kLength = 1000;
  EXPECT_NEAR(scaled(preview.page(), kLength), ratio * scaleFor(wide) * kLength, 0.01 * kLength);
}

TEST(PreviewWindow, KeepsTheOrderAndTheLabelsOfThePageBefore) {
  PreviewWindow preview(shipped("punch-counterbalanced"));
  preview.show();
  const auto labels = [&] {
    std::vector<int> all;
    for (const auto& step : preview.controller().session().plan()) all.push_back(step.label);
    return all;
  };
  const auto first = labels();
  for (const int step : {6, 9, 2}) {
    preview.goTo(step);
    EXPECT_EQ(labels(), first) << step;
  }
}

TEST(PreviewWindow, ShowsPagesAsLargeAsItself) {
  PreviewWindow preview(shipped("punch-face-validity"));
  preview.resize(1366, 768);
  preview.show();
  auto* sizes = preview.findChild<QComboBox*>(QStringLiteral("size"));
  sizes->setCurrentIndex(sizes->findData(QSize()));
  QCoreApplication::processEvents();
  const auto* place = preview.findChild<QScrollArea*>();
  EXPECT_EQ(preview.page().size(), place->viewport()->size());
}

TEST(PreviewWindow, CountsTheTextsThatAreStillBlankAsTheHomePageDoes) {
  PreviewWindow preview(shipped("punch-face-validity"));
  preview.show();
  const auto words = tests::wordsIn(preview);
  EXPECT_TRUE(std::ranges::any_of(words, [](const QString& text) {
    return text.contains(QStringLiteral("Texts that are still blank: 10."));
  }));
}

TEST(PreviewWindow, LetsAnAlternativeBeFelt) {
  PreviewWindow preview(shipped("punch-face-validity"));
  preview.show();
  const auto& plan = preview.controller().session().plan();
  int trial = 0;
  while (plan[static_cast<std::size_t>(trial)].kind != StepKind::Trial) ++trial;
  preview.goTo(trial);
  auto* begin = tests::buttonSaying(&preview.page(), QStringLiteral("Begin"));
  ASSERT_NE(begin, nullptr);
  QTest::mouseClick(begin, Qt::LeftButton);
  EXPECT_TRUE(preview.controller().isTrialRunning());
  QTest::keyPress(&preview.page(), Qt::Key_Escape);
  EXPECT_TRUE(QTest::qWaitFor([&] { return !preview.controller().isTrialRunning(); }));
}

}  // namespace preview_window_test
}  // namespace study::gui
