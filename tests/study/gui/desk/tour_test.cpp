#include "study/gui/desk/tour.h"

#include <algorithm>

#include <gtest/gtest.h>

#include <QTest>

#include "study/gui/participant/option_buttons.h"
#include "study/gui/participant/trial_page.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/studio_settings.h"
#include "tests/study/gui/participant.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/gui/visible_words.h"

namespace study::gui {
namespace tour_test {

using tests::buttonSaying;

class TourTest : public testing::Test {
 protected:
  void SetUp() override { studioSettings().clear(); }

  static void next(Tour& tour) {
    QTest::mouseClick(tour.findChild<QPushButton*>(QStringLiteral("tour-next")), Qt::LeftButton);
  }
};

TEST_F(TourTest, LetsTheUserFeelAPunchAndShowsTheRecord) {
  Tour tour;
  tour.show();
  auto* page = tour.findChild<TrialPage*>();
  const auto* onwards = tour.findChild<QPushButton*>(QStringLiteral("tour-next"));
  QTest::mouseClick(buttonSaying(page, QStringLiteral("Begin")), Qt::LeftButton);
  const auto words = tests::wordsIn(tour);
  EXPECT_TRUE(std::none_of(words.begin(), words.end(), [](const QString& text) {
    return text.contains(QStringLiteral("press Begin"));
  })) << "the button is gone";
  auto* enough = buttonSaying(page, QStringLiteral("Done"));
  ASSERT_NE(enough, nullptr);
  // The hand moves in real time: where the machine stands still, one stroke may be too short to be
  // felt.
  for (int stroke = 0; stroke < 10 && !enough->isEnabled(); ++stroke) {
    QTest::keyPress(page, Qt::Key_Space);
    QTest::qWait(1300);  // longer than the hand takes to close
    QTest::keyRelease(page, Qt::Key_Space);
    if (QTest::qWaitFor([&] { return enough->isEnabled(); })) break;
  }
  ASSERT_TRUE(enough->isEnabled());
  EXPECT_FALSE(onwards->isVisible()) << "the button of the page is the only way on";
  EXPECT_FALSE(page->findChild<QLabel*>(QStringLiteral("pointer-hint"))->isVisible());
  tests::photographInAllThemes(tour, QStringLiteral("tour-1"));
  QTest::mouseClick(enough, Qt::LeftButton);
  EXPECT_EQ(tour.step(), 1);
  EXPECT_EQ(onwards->property("role").toString(), QStringLiteral("main"));
  ASSERT_TRUE(tour.trialRecord());
  EXPECT_GE(tour.trialRecord()->cuts.size(), 1U);
  EXPECT_GT(tour.trialRecord()->largestForce, 1.0);
  EXPECT_FALSE(tour.findChildren<OptionButtons*>().empty());
  tests::photographInAllThemes(tour, QStringLiteral("tour-2"));
  next(tour);
  auto* record = tour.findChild<QTableWidget*>(QStringLiteral("tour-record"));
  ASSERT_GT(record->rowCount(), 4);
  EXPECT_EQ(record->item(0, 1)->text().toLongLong(), tour.trialRecord()->traceSamples);
  tests::photographInAllThemes(tour, QStringLiteral("tour-3"));
}

TEST_F(TourTest, HasTheParticipantsPageInTheLanguageOfTheDesk) {
  setDeskLanguage("de");
  {
    Tour tour;
    tour.show();
    auto* page = tour.findChild<TrialPage*>();
    QTest::mouseClick(buttonSaying(page, QStringLiteral("Beginnen")), Qt::LeftButton);
    QString words;
    for (const auto* label : page->findChildren<QLabel*>()) words += label->text();
    EXPECT_TRUE(words.contains(QStringLiteral("0 von 1"))) << words.toStdString();
  }
  setDeskLanguage("en");
}

TEST_F(TourTest, ShowsAnEmptyRecordWithoutATrial) {
  Tour tour;
  tour.show();
  next(tour);
  next(tour);
  EXPECT_EQ(tour.step(), 2);
  EXPECT_EQ(tour.findChild<QTableWidget*>(QStringLiteral("tour-record"))->rowCount(), 0);
}

TEST_F(TourTest, IsOfferedOnce) {
  EXPECT_TRUE(Tour::isUnseen());
  Tour tour;
  tour.show();
  tour.reject();
  EXPECT_FALSE(Tour::isUnseen());
}

TEST_F(TourTest, NamesNoCondition) {
  Tour tour;
  tour.show();
  for (auto* widget : tour.findChildren<QWidget*>()) {
    for (const auto& words : {widget->accessibleName(), widget->objectName(), widget->toolTip()}) {
      EXPECT_FALSE(words.contains(QStringLiteral("interpolation"), Qt::CaseInsensitive));
    }
  }
  for (auto* label : tour.findChildren<QLabel*>()) {
    EXPECT_FALSE(label->text().contains(QStringLiteral("interpolation"), Qt::CaseInsensitive));
  }
}

}  // namespace tour_test
}  // namespace study::gui
