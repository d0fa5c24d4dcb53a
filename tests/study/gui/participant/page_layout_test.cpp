// Where things are on a participant's pages.
#include <algorithm>
#include <set>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include <QCoreApplication>
#include <QLabel>
#include <QProgressBar>
#include <QTest>

#include "haptics/devices/punch/punch_kind.h"
#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/participant/blank_text.h"
#include "study/gui/participant/option_buttons.h"
#include "study/gui/participant/questionnaire_page.h"
#include "study/gui/participant/side_by_side.h"
#include "study/gui/participant/trial_page.h"
#include "study/gui/widgets/labels.h"
#include "tests/study/gui/participant.h"
#include "tests/study/known_secret.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace page_layout_test {

constexpr QSize kScreen(1920, 1080);

/// A session of a shipped protocol with its windows.
struct Pages {
  explicit Pages(const std::string& name) : protocol(*protocols::loadProtocolFile(name, problems)) {
    window.show();
    window.enrol(
        {.cohort = protocol.protocol.cohorts.front().id,
         .runMode = RunMode::Pilot,
         .language = "en",
         .code = {}});
    page().resize(kScreen);
  }

  /// Waits until the layouts have settled.
  static void settle() {
    constexpr int kRounds = 10;
    for (int i = 0; i < kRounds; ++i) QCoreApplication::processEvents();
  }

  QWidget& page() { return *window.participantWindow(); }
  const Session& session() { return window.controller()->session(); }

  /// Goes on by skipping until a step of @p kind; false if there is none left.
  bool skipTo(StepKind kind) {
    while (!session().isOver() && session().step().kind != kind) {
      window.controller()->skipStep(QStringLiteral("not needed here"));
    }
    QCoreApplication::processEvents();
    return !session().isOver();
  }

  std::vector<std::string> labels() {
    std::vector<std::string> texts;
    for (const auto* label : page().findChildren<QLabel*>()) {
      if (label->isVisible()) texts.push_back(label->text().toStdString());
    }
    return texts;
  }

  bool says(const std::string& part) {
    const auto texts = labels();
    return std::any_of(texts.begin(), texts.end(), [&](const std::string& text) {
      return text.find(part) != std::string::npos;
    });
  }

  questionnaires::Problems problems;
  tests::ScratchFolder folder;
  SystemClock clock;
  protocols::LoadedProtocol protocol;
  Study study{Study::create(folder / "study", protocol, clock, 7, tests::knownSecret())};
  OperatorWindow window{study};
  tests::Participant participant{window};
};

QPushButton* mainButton(QWidget& page) {
  QPushButton* found = nullptr;
  for (auto* button : page.findChildren<QPushButton*>()) {
    if (!button->isVisible() || button->property("role") != QStringLiteral("next")) continue;
    EXPECT_EQ(found, nullptr) << "two main buttons";
    found = button;
  }
  return found;
}

QRect placeIn(QWidget& page, const QWidget& widget) {
  return {widget.mapTo(&page, QPoint(0, 0)), widget.size()};
}

TEST(PageLayout, HasTheMainButtonAtOnePlaceAndNoDeadBack) {
  Pages pages("punch-face-validity");
  std::set<StepKind> seen;
  std::vector<QRect> places;
  const auto look = [&] {
    Pages::settle();
    for (const auto* button : pages.page().findChildren<QPushButton*>()) {
      if (button->isVisible() && button->property("role") == QStringLiteral("back")) {
        EXPECT_TRUE(button->isEnabled());
      }
    }
    auto* button = mainButton(pages.page());
    ASSERT_NE(button, nullptr);
    places.push_back(placeIn(pages.page(), *button));
    EXPECT_EQ(places.back(), places.front()) << button->text().toStdString();
  };
  while (seen.count(StepKind::Preference) == 0) {
    const auto kind = pages.session().step().kind;
    if (seen.insert(kind).second) {
      look();
      if (kind == StepKind::Trial) {
        pages.window.controller()->beginTrial();
        look();
        EXPECT_TRUE(pages.says("3 cuts left"));
        pages.window.controller()->stop();
        pages.window.controller()->repeatStep(QStringLiteral("only looked at"));
      }
    }
    if (pages.session().allows(SessionEvent::SkippedStep)) {
      pages.window.controller()->skipStep(QStringLiteral("walking on"));
    } else {
      pages.participant.doStep();
    }
    if (pages.session().isOver()) break;
  }
  EXPECT_GE(places.size(), 7U);
}

TEST(PageLayout, HasTheEndOfTheBarAndTheTitleAtOnePlaceOnEveryPage) {
  Pages pages("punch-counterbalanced");
  std::set<StepKind> seen;
  std::set<int> ends;
  std::set<int> titles;
  const auto look = [&] {
    Pages::settle();
    ends.insert(placeIn(pages.page(), *pages.page().findChild<QProgressBar*>()).right());
    for (const auto* label : pages.page().findChildren<QLabel*>()) {
      if (label->isVisible() && label->property("role") == QStringLiteral("title"))
        titles.insert(placeIn(pages.page(), *label).top());
    }
  };
  for (; !pages.session().isOver(); pages.participant.doStep()) {
    const auto kind = pages.session().step().kind;
    if (kind == StepKind::Break) break;  // its words are in the middle
    if (seen.insert(kind).second) look();
  }
  EXPECT_GE(seen.size(), 7U);
  EXPECT_EQ(ends.size(), 1U);
  EXPECT_EQ(titles.size(), 1U);
}

TEST(PageLayout, SaysWhichInstrumentIsRealAndHowToStop) {
  Pages pages("punch-counterbalanced");
  for (const auto kind : {StepKind::Benchmark, StepKind::Trial}) {
    pages.participant.goTo(kind);
    Pages::settle();
    EXPECT_EQ(pages.says("The handle of the simulator"), kind == StepKind::Trial);
    EXPECT_EQ(pages.says("The real instrument, not the simulator"), kind == StepKind::Benchmark);
    EXPECT_TRUE(pages.says(
        kind == StepKind::Benchmark
            ? "To pause or stop: put the instrument down, and tell the researcher."
            : "To pause or stop: let go, and tell the researcher."));
  }
}

TEST(PageLayout, HasThePictureBesideTheWordsAndAboveTheButtonOnAnUprightScreen) {
  Pages pages("two-devices");
  pages.participant.goTo(StepKind::Trial);
  QTest::qWait(100);  // the picture is made a moment later
  auto* page = pages.page().findChild<TrialPage*>();
  auto* picture = page->findChild<QWidget*>(QStringLiteral("scene"));
  ASSERT_NE(picture, nullptr);
  const auto place = [&](const QWidget& widget) { return placeIn(pages.page(), widget); };
  for (const QSize size : {QSize(1024, 700), QSize(1366, 768), kScreen, QSize(3840, 2160)}) {
    pages.page().resize(size);
    Pages::settle();
    EXPECT_GE(picture->height(), 0.85 * page->height()) << size.width();
    EXPECT_GE(picture->width(), 0.5 * page->width()) << size.width();
    EXPECT_LE(place(*picture).right(), place(*mainButton(pages.page())).left()) << size.width();
  }
  pages.page().resize(1080, 1920);
  Pages::settle();
  EXPECT_GE(picture->width(), 0.9 * page->width());
  EXPECT_LE(place(*picture).bottom(), place(*mainButton(pages.page())).top());
}

TEST(PageLayout, SaysHowToMoveTheInstrumentByKeysOnlyIfItIsVirtual) {
  const auto& punch = haptics::devices::punchKind();
  TrialPage page({.name = QStringLiteral("Tissue 1"), .device = &punch}, nullptr);
  page.show();
  const auto* hint = page.findChild<QLabel*>(QStringLiteral("pointer-hint"));
  page.setRunning(true, false);
  EXPECT_FALSE(hint->isVisible());
  page.setRunning(true, true);
  EXPECT_TRUE(hint->isVisible());
  EXPECT_EQ(hint->text(), asText(punch.pointerHint.in("en")));
}

TEST(PageLayout, SaysThatThereIsNoPictureOnlyWhereAnotherRoundHasOne) {
  const std::string words = "By feel alone";
  Pages both("punch-face-validity");
  both.participant.goTo(StepKind::Trial);
  QCoreApplication::processEvents();
  EXPECT_TRUE(both.says(words));
  const auto block = both.session().step().phase;
  while (both.skipTo(StepKind::Trial) && both.session().step().phase == block) {
    both.window.controller()->skipStep(QStringLiteral("not needed here"));
  }
  ASSERT_FALSE(both.session().isOver());
  QCoreApplication::processEvents();
  EXPECT_FALSE(both.says(words));
}

TEST(PageLayout, SaysWhenEachAlternativeWasFelt) {
  Pages pages("punch-face-validity");
  pages.participant.goTo(StepKind::Trial);
  std::vector<QStringList> choices;
  while (pages.skipTo(StepKind::Preference)) {
    const auto* buttons = pages.page().findChild<OptionButtons*>();
    choices.emplace_back();
    for (int i = 0; i < 3; ++i) choices.back() << buttons->button(i)->text();
    pages.window.controller()->skipStep(QStringLiteral("not needed here"));
  }
  ASSERT_EQ(choices.size(), 2U);
  EXPECT_EQ(choices[0][0], QStringLiteral("Alternative 1\nfelt first"));
  EXPECT_EQ(choices[1][0], QStringLiteral("Alternative 1\nfelt third")) << "the order is 3-2-1";
  EXPECT_EQ(choices[1][2], QStringLiteral("Alternative 3\nfelt first"));
}

TEST(PageLayout, HasLongTextsInTwoColumnsWhereThereIsRoom) {
  Pages pages("punch-face-validity");
  const auto* parts = pages.page().findChild<SideBySide*>();
  ASSERT_NE(parts, nullptr);
  for (const int width : {1920, 1024, 1366, 683}) {
    pages.page().resize(width, width * 9 / 16);
    Pages::settle();
    EXPECT_EQ(parts->isSideBySide(), width >= 1366) << width;
  }
}

TEST(PageLayout, HasAsManyOptionsBesideEachOtherAsFitInEqualRows) {
  const auto row = [](const OptionButtons& buttons) {
    int count = 0;
    for (int i = 0; i < 6; ++i) {
      if (buttons.button(i)->y() == buttons.button(0)->y()) ++count;
    }
    return count;
  };
  QWidget page;
  OptionButtons buttons(
      {{"none", {}}, {"one", {}}, {"two", {}}, {"three", {}}, {"four", {}}, {"several", {}}},
      OptionButtons::kAsManyAsFit,
      QStringLiteral("option"),
      &page);
  page.show();
  const int wide = buttons.button(5)->sizeHint().width();
  for (const auto& [width, columns] : std::vector<std::pair<int, int>>{
           {7 * wide, 6}, {5 * wide, 3}, {3 * wide - 1, 2}, {wide, 1}, {7 * wide, 6}}) {
    buttons.resize(width, 400);
    QCoreApplication::processEvents();
    EXPECT_EQ(buttons.width(), width);
    EXPECT_EQ(row(buttons), columns) << width;
  }
}

TEST(PageLayout, NamesEachPointWhoseWordsTheInstrumentHas) {
  questionnaires::Item item{.id = "a", .type = questionnaires::ItemType::Likert};
  item.scale.points = 3;
  for (const char* word : {"none", "some", "much"}) {
    item.scale.pointLabels.emplace_back(questionnaires::LocalizedText({{"en", word}}));
  }
  QuestionnairePage page(
      {.title = {},
       .introduction = {},
       .items = {item},
       .choices = {},
       .language = QStringLiteral("en"),
       .before = {}});
  page.resize(kScreen);
  page.show();
  QCoreApplication::processEvents();
  const auto* points = page.findChild<OptionButtons*>();
  for (int i = 0; i < 3; ++i) {
    const auto place = placeIn(page, *points->button(i));
    const auto labels = page.findChildren<QLabel*>();
    EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
      const auto words = placeIn(page, *label);
      return label->text() == QString::fromStdString(item.scale.pointLabels[i].in("en")) &&
             words.top() >= place.bottom() && std::abs(words.center().x() - place.center().x()) < 4;
    })) << i;
  }
}

TEST(PageLayout, HasTheWordsOfAnEndUnderItsPoint) {
  questionnaires::Item item{.id = "a", .type = questionnaires::ItemType::Likert};
  item.scale.points = 5;
  item.scale.lowLabel = questionnaires::LocalizedText({{"en", "strongly disagree"}});
  item.scale.highLabel = questionnaires::LocalizedText({{"en", "strongly agree"}});
  QuestionnairePage page(
      {.title = {},
       .introduction = {},
       .items = {item},
       .choices = {},
       .language = QStringLiteral("en"),
       .before = {}});
  page.show();
  const auto* points = page.findChild<OptionButtons*>();
  for (const QSize size : {kScreen, QSize(683, 384)}) {
    page.resize(size);
    Pages::settle();
    for (const auto* label : page.findChildren<QLabel*>()) {
      if (!label->text().startsWith(QStringLiteral("strongly"))) continue;
      const auto* point =
          points->button(label->text().endsWith(QStringLiteral("disagree")) ? 0 : 4);
      const auto words = placeIn(page, *label);
      const auto box = placeIn(page, *point);
      constexpr int kHalfAGap = 4;
      EXPECT_NEAR(words.center().x(), box.center().x(), kHalfAGap);
      EXPECT_LE(words.width(), box.width() + 2 * kHalfAGap);
    }
  }
}

TEST(PageLayout, TearsNoDateAndNoTitleFromItsName) {
  const QString text = QStringLiteral("Until 31 March 2027: Dr Anna Berg.\n1. First");
  QString bound = text;
  for (const auto* part : {"31 March", "Dr Anna Berg"}) {
    const auto words = QString::fromLatin1(part);
    bound.replace(words, QString(words).replace(u' ', QChar(QChar::Nbsp)));
  }
  bound.replace(
      QStringLiteral("March 2027"), QStringLiteral("March") + QChar(QChar::Nbsp) + "2027");
  EXPECT_EQ(withUnbrokenNumbers(text), bound);
}

}  // namespace page_layout_test
}  // namespace study::gui
