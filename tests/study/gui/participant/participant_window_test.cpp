// The participant's window in right-to-left languages, with a screen reader, and by keyboard.
#include "study/gui/participant/participant_window.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <QAccessible>
#include <QApplication>
#include <QComboBox>
#include <QCoreApplication>
#include <QLabel>
#include <QTest>
#include <QTimer>
#include <QVariantAnimation>

#include "haptics/devices/punch/punch_kind.h"
#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "study/gui/operator/consent_copy_dialog.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/participant/column.h"
#include "study/gui/participant/option_buttons.h"
#include "study/gui/participant/questionnaire_page.h"
#include "study/gui/participant/trial_page.h"
#include "study/session/erasure_copies.h"
#include "tests/study/gui/participant.h"
#include "tests/study/gui/visible_words.h"
#include "tests/study/known_secret.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace participant_window_test {

/// The published punch study in its own languages and in Arabic. Texts without a translation appear
/// in the first language.
class ParticipantPages : public testing::Test {
 protected:
  protocols::LoadedProtocol protocol() {
    questionnaires::Problems problems;
    const auto shipped = protocols::loadProtocolFile("punch-face-validity", problems);
    auto json = nlohmann::ordered_json::parse(shipped->text);
    json["languages"] = {"en", "de", "ar"};
    json["labels"]["prefix"]["ar"] = "البديل";
    return *protocols::loadProtocolFile(folder_.write("protocol.json", json.dump()), problems);
  }

  ParticipantWindow& page() { return *window_.participantWindow(); }

  void choose(const char* language) {
    auto* box = page().findChild<QComboBox*>();
    box->setCurrentIndex(box->findData(QString::fromUtf8(language)));
    QCoreApplication::processEvents();
  }

  tests::ScratchFolder folder_;
  SystemClock clock_;
  Study study_{Study::create(folder_ / "study", protocol(), clock_, 7, tests::knownSecret())};
  OperatorWindow window_{study_};
  tests::Participant participant_{window_};
};

/// The title of the first trial of a session of the shipped @p protocol.
QString titleOfTrial(const std::string& protocol) {
  const tests::ScratchFolder folder;
  SystemClock clock;
  questionnaires::Problems problems;
  const auto loaded = protocols::loadProtocolFile(protocol, problems);
  auto study = Study::create(folder / "study", *loaded, clock, 7, tests::knownSecret());
  OperatorWindow window(study);
  window.show();
  window.enrol({.cohort = "professional", .runMode = RunMode::Pilot, .language = "en", .code = {}});
  tests::Participant(window).goTo(StepKind::Trial);
  QCoreApplication::processEvents();
  return window.participantWindow()->findChild<TrialPage*>()->accessibleName();
}

TEST_F(ParticipantPages, SwitchToRightToLeftAndBack) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "ar", .code = {}});
  EXPECT_EQ(page().layoutDirection(), Qt::RightToLeft);
  EXPECT_EQ(window_.layoutDirection(), Qt::LeftToRight) << "the operator reads English";
  choose("de");
  EXPECT_EQ(page().layoutDirection(), Qt::LeftToRight);
  EXPECT_NE(tests::buttonSaying(&page(), QStringLiteral("Weiter")), nullptr);
  choose("ar");
  EXPECT_EQ(page().layoutDirection(), Qt::RightToLeft);
  EXPECT_EQ(window_.controller()->session().language(), "ar");
}

TEST_F(ParticipantPages, OfferLanguagesOnTheFirstPageOnly) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  EXPECT_TRUE(page().findChild<QComboBox*>()->isVisible());
  participant_.takePart(1);
  EXPECT_FALSE(page().findChild<QComboBox*>()->isVisible());
}

TEST_F(ParticipantPages, ExplainWhyNextDoesNotGoOn) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  participant_.goTo(StepKind::Questionnaire);
  QCoreApplication::processEvents();
  const int step = window_.controller()->session().stepIndex();
  const auto rows = page().findChildren<OptionButtons*>();
  const auto items = static_cast<int>(rows.size());
  const auto says = [&](int open) {
    return tests::wordsIn(page()).count(QStringLiteral("%1 questions still open").arg(open)) == 1;
  };
  EXPECT_FALSE(says(items));
  QTest::mouseClick(tests::buttonSaying(&page(), QStringLiteral("Next")), Qt::LeftButton);
  EXPECT_EQ(window_.controller()->session().stepIndex(), step);
  EXPECT_TRUE(says(items));
  EXPECT_TRUE(rows[0]->button(0)->hasFocus());
  QTest::mouseClick(rows[0]->button(0), Qt::LeftButton);
  EXPECT_TRUE(says(items - 1));
}

TEST_F(ParticipantPages, BeginNoTrialByTheSecondPressOfADoubleClickOnNext) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  participant_.goTo(StepKind::Questionnaire);
  QCoreApplication::processEvents();
  auto* newPage = page().findChild<QTimer*>(QStringLiteral("new-page"));
  ASSERT_NE(newPage, nullptr);
  const auto waitForItsEnd = [&] {
    newPage->start(0);
    ASSERT_TRUE(QTest::qWaitFor([&] { return !newPage->isActive(); }));
    newPage->setInterval(std::chrono::hours(1));  // of the next page: it ends only here
  };
  waitForItsEnd();
  // As a mouse does: what lies at the place gets the press.
  const auto press = [&](const char* words) {
    QCoreApplication::processEvents();
    const auto* button = tests::buttonSaying(&page(), QString::fromUtf8(words));
    ASSERT_NE(button, nullptr) << words;
    const auto place = button->mapTo(&page(), button->rect().center());
    QTest::mouseClick(page().windowHandle(), Qt::LeftButton, {}, place);
  };
  for (auto* row : page().findChildren<OptionButtons*>())
    QTest::mouseClick(row->button(0), Qt::LeftButton);
  press("Next");
  ASSERT_EQ(window_.controller()->session().step().kind, StepKind::Trial);
  press("Begin");
  EXPECT_FALSE(window_.controller()->isTrialRunning());
  waitForItsEnd();
  press("Begin");
  EXPECT_TRUE(window_.controller()->isTrialRunning());
  EXPECT_TRUE(newPage->isActive()) << "the second press of a double click on Begin is none on Done";
  window_.controller()->stop();
}

TEST_F(ParticipantPages, SayWhichStepOfHowManyItIs) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  const auto steps = window_.controller()->session().plan().size();
  EXPECT_EQ(tests::wordsIn(page()).count(QStringLiteral("Step 1 of %1").arg(steps)), 1U);
}

TEST_F(ParticipantPages, SayWhichRoundAndTrialOfHowManyItIs) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  participant_.goTo(StepKind::Trial);
  const auto& session = window_.controller()->session();
  QStringList places;
  for (; !session.isOver(); window_.controller()->skipStep(QStringLiteral("not needed here"))) {
    QCoreApplication::processEvents();
    for (const auto& words : tests::wordsIn(page())) {
      if (words.startsWith(QStringLiteral("Round "))) places << words;
    }
  }
  EXPECT_EQ(places.size(), 2 * (3 + 1)) << "questions on a trial that was skipped are not asked";
  EXPECT_EQ(places.value(1), QStringLiteral("Round 1 of 2 · Trial 2 of 3"));
  EXPECT_EQ(places.value(3), QStringLiteral("Round 1 of 2")) << "the comparison";
  EXPECT_EQ(places.value(4), QStringLiteral("Round 2 of 2 · Trial 1 of 3"));
}

TEST(ParticipantTitles, NameTheAlternativeAlikeWhereverItsNumberComesFrom) {
  EXPECT_EQ(titleOfTrial("punch-counterbalanced"), QStringLiteral("Alternative 1"));
  EXPECT_EQ(titleOfTrial("punch-face-validity"), QStringLiteral("Alternative 1"));
}

TEST_F(ParticipantPages, SayAtAPreferenceWhetherAnotherRoundFollows) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  participant_.goTo(StepKind::Trial);
  const auto& session = window_.controller()->session();
  std::vector<bool> said;
  for (; !session.isOver(); window_.controller()->skipStep(QStringLiteral("not needed here"))) {
    if (session.step().kind != StepKind::Preference) continue;
    QCoreApplication::processEvents();
    const auto words = tests::wordsIn(page());
    said.push_back(std::any_of(words.begin(), words.end(), [](const QString& text) {
      return text.contains(QStringLiteral("another round follows"));
    }));
  }
  EXPECT_EQ(said, (std::vector<bool>{true, false}));
}

TEST_F(ParticipantPages, GiveTheCodeToWhoeverLeaves) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  window_.controller()->withdraw({});
  QCoreApplication::processEvents();
  const auto words = tests::wordsIn(page());
  EXPECT_TRUE(words.contains(QStringLiteral("You have left the study")));
  EXPECT_TRUE(words.contains(QStringLiteral("P001")));
}

TEST_F(ParticipantPages, ExplainNothingToWhomMayBeginAgain) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  window_.controller()->reject(QStringLiteral("the wrong cohort"));
  QCoreApplication::processEvents();
  const auto words = tests::wordsIn(page());
  EXPECT_TRUE(words.contains(QStringLiteral("This session has ended")));
  EXPECT_FALSE(words.contains(QStringLiteral("Thank you")));
}

TEST_F(ParticipantPages, EndWithOneThankYouPage) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  const auto& session = window_.controller()->session();
  const int last = static_cast<int>(session.plan().size()) - 1;
  while (session.stepIndex() < last - 1) {
    session.allows(SessionEvent::SkippedStep)
        ? window_.controller()->skipStep(QStringLiteral("quicker"))
        : participant_.doStep();
  }
  participant_.takePart(last);
  QCoreApplication::processEvents();
  const auto headings = [&] { return tests::wordsIn(page()).count(QStringLiteral("Thank you")); };
  EXPECT_EQ(headings(), 1U);
  QTest::mouseClick(tests::buttonSaying(&page(), QStringLiteral("Finish")), Qt::LeftButton);
  QCoreApplication::processEvents();
  ASSERT_TRUE(session.isOver());
  const auto words = tests::wordsIn(page());
  EXPECT_EQ(words.count(QStringLiteral("Finished")), 1U);
  EXPECT_TRUE(std::any_of(words.begin(), words.end(), [](const QString& text) {
    return text.contains(QStringLiteral("Please do not talk with other participants"));
  })) << "the debrief can still be read";
}

TEST_F(ParticipantPages, LetTheInformationBeReadAgainAndLoseNothing) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  participant_.goTo(StepKind::Consent);
  QCoreApplication::processEvents();
  const auto& session = window_.controller()->session();
  const int step = session.stepIndex();
  QTest::mouseClick(page().findChild<OptionButtons*>()->button(0), Qt::LeftButton);
  QTest::keyClicks(page().findChild<QLineEdit*>(), QStringLiteral("Ada"));
  QTest::mouseClick(tests::buttonSaying(&page(), QStringLiteral("Back")), Qt::LeftButton);
  QCoreApplication::processEvents();
  EXPECT_EQ(tests::wordsIn(page()).count(QStringLiteral("About this study")), 1U);
  EXPECT_EQ(tests::buttonSaying(&page(), QStringLiteral("Back")), nullptr);
  EXPECT_EQ(session.stepIndex(), step) << "the session does not go back";
  QTest::mouseClick(tests::buttonSaying(&page(), QStringLiteral("Next")), Qt::LeftButton);
  QCoreApplication::processEvents();
  EXPECT_EQ(session.stepIndex(), step);
  EXPECT_EQ(page().findChild<OptionButtons*>()->chosen(), 0);
  EXPECT_EQ(page().findChild<QLineEdit*>()->text(), QStringLiteral("Ada"));
}

TEST_F(ParticipantPages, ShowOneTextAgainAlsoWhenAnAnswerIsStoredMeanwhile) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  participant_.goTo(StepKind::Consent);
  QCoreApplication::processEvents();
  QTest::mouseClick(tests::buttonSaying(&page(), QStringLiteral("Back")), Qt::LeftButton);
  QCoreApplication::processEvents();
  for (auto* questions : page().findChildren<QuestionnairePage*>()) {
    emit questions->progressChanged();  // as when typing rests
  }
  QCoreApplication::processEvents();
  EXPECT_EQ(tests::buttonSaying(&page(), QStringLiteral("Back")), nullptr);
  QTest::mouseClick(tests::buttonSaying(&page(), QStringLiteral("Next")), Qt::LeftButton);
  QCoreApplication::processEvents();
  EXPECT_EQ(tests::wordsIn(page()).count(QStringLiteral("About this study")), 0U);
  EXPECT_NE(tests::buttonSaying(&page(), QStringLiteral("Back")), nullptr);
}

TEST_F(ParticipantPages, MarkBlanksThatAreStillToBeFilledIn) {
  window_.show();
  window_.enrol(
      {.cohort = "professional", .runMode = RunMode::Pilot, .language = "en", .code = {}});
  QStringList marked;
  for (const auto& words : tests::wordsIn(page())) {
    if (words.contains(QStringLiteral("[[duration: to be filled in]]"))) marked << words;
  }
  ASSERT_FALSE(marked.isEmpty());
  EXPECT_FALSE(marked.filter(QStringLiteral("background-color")).isEmpty())
      << marked.front().toStdString();
}

TEST(ParticipantScale, GrowsWithTheScreen) {
  EXPECT_EQ(scaleFor({1100, 760}), 1.0);
  EXPECT_EQ(scaleFor({683, 384}), 1.0);
  constexpr double kText = 17.0;  // [px] at scale 1
  EXPECT_NEAR(kText * scaleFor({1920, 1080}), 23.0, 1.0);
  EXPECT_NEAR(kText * scaleFor({3840, 2160}), 46.0, 1.0);
}

TEST_F(ParticipantPages, AreReadInAColumnOfAboutSeventyCharacters) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  for (const QSize size : {QSize(1366, 768), QSize(1920, 1080), QSize(3840, 2160)}) {
    page().resize(size);
    QCoreApplication::processEvents();
    for (auto* label : page().findChildren<QLabel*>()) {
      if (!label->isVisible() || label->property("role") != QStringLiteral("text")) continue;
      const auto width = label->fontMetrics().horizontalAdvance(
          QStringLiteral("The movement of the handle and the force at it during your cuts, with "));
      EXPECT_NEAR(70.0 * label->width() / width, 70.0, 12.0) << size.width();
    }
  }
}

TEST_F(ParticipantPages, CountBenchmarkCutsByAKeyInEveryWindow) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  QTest::keyClick(&page(), Qt::Key_F9);  // no benchmark: nothing happens
  participant_.goTo(StepKind::Benchmark);
  QCoreApplication::processEvents();
  const auto& session = window_.controller()->session();
  EXPECT_EQ(session.benchmarkCuts(), 0);
  QTest::keyClick(&page(), Qt::Key_F9);
  QTest::keyClick(&window_, Qt::Key_F9);
  EXPECT_EQ(session.benchmarkCuts(), 2);
  const auto words = tests::wordsIn(page());
  EXPECT_TRUE(std::any_of(words.begin(), words.end(), [](const QString& text) {
    return text.startsWith(QStringLiteral("2 of 3 cuts"));
  }));
}

TEST_F(ParticipantPages, MirrorScalesInRightToLeftLanguages) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  const auto& plan = window_.controller()->session().plan();
  int questions = 0;
  while (plan[static_cast<std::size_t>(questions)].kind != StepKind::Questionnaire) ++questions;
  participant_.takePart(questions);
  choose("ar");
  participant_.look();
  auto* scale = page().findChild<OptionButtons*>();
  QCoreApplication::processEvents();
  EXPECT_GT(scale->button(0)->x(), scale->button(4)->x());
  // The key that moves to the left moves to the larger number.
  scale->button(1)->setFocus();
  QTest::keyClick(scale->button(1), Qt::Key_Left);
  QTest::keyClick(scale->button(2), Qt::Key_Space);
  EXPECT_EQ(scale->chosen(), 2);
  const auto answers = window_.controller()->session().answers();
  ASSERT_EQ(answers.size(), 1U);
  EXPECT_EQ(answers.front().response, questionnaires::Response(std::int64_t{3}));
  EXPECT_EQ(answers.front().language, "ar");
}

/// Collects all elements that a screen reader can focus.
void collect(QAccessibleInterface* node, std::vector<QAccessibleInterface*>& found) {
  if (node == nullptr) return;
  if (node->state().focusable && !node->state().invisible) found.push_back(node);
  for (int i = 0; i < node->childCount(); ++i) collect(node->child(i), found);
}

TEST_F(ParticipantPages, GiveAScreenReaderStatementEndsPositionAndState) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  const auto& session = window_.controller()->session();
  int questions = 0;
  while (session.plan()[static_cast<std::size_t>(questions)].kind != StepKind::Questionnaire) {
    ++questions;
  }
  participant_.takePart(questions);
  QCoreApplication::processEvents();
  const auto items = session.items();
  for (const auto& item : items) {
    const auto statement = QString::fromStdString(item.text.in("en"));
    const auto low = QString::fromStdString(item.scale.lowLabel.in("en"));
    const auto high = QString::fromStdString(item.scale.highLabel.in("en"));
    std::vector<QAccessibleInterface*> stops;
    collect(QAccessible::queryAccessibleInterface(&page()), stops);
    std::vector<QAccessibleInterface*> points;
    for (auto* stop : stops) {
      if (stop->text(QAccessible::Name).startsWith(statement)) points.push_back(stop);
    }
    ASSERT_EQ(points.size(), static_cast<std::size_t>(item.scale.points)) << item.id;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const QString name = points[i]->text(QAccessible::Name);
      const auto place = QStringLiteral("%1 of %2").arg(i + 1).arg(points.size());
      EXPECT_TRUE(name.contains(place)) << name.toStdString();
      EXPECT_TRUE(name.contains(low) && name.contains(high)) << name.toStdString();
      EXPECT_TRUE(points[i]->state().checkable);
      EXPECT_FALSE(points[i]->state().checked) << "no default answer";
    }
    points[1]->actionInterface()->doAction(QAccessibleActionInterface::toggleAction());
    EXPECT_TRUE(points[1]->state().checked);
    EXPECT_FALSE(points[0]->state().checked);
  }
  EXPECT_EQ(session.answers().size(), items.size()) << "a screen reader's choices are saved";
}

TEST_F(ParticipantPages, CanBeAnsweredByKeyboardAlone) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  const auto& session = window_.controller()->session();
  int questions = 0;
  while (session.plan()[static_cast<std::size_t>(questions)].kind != StepKind::Questionnaire) {
    ++questions;
  }
  participant_.takePart(questions);
  QCoreApplication::processEvents();
  // No answer has a focus frame before the first key press.
  for (auto* scale : page().findChildren<OptionButtons*>()) {
    EXPECT_FALSE(scale->isAncestorOf(QApplication::focusWidget()));
    EXPECT_LT(scale->chosen(), 0);
  }
  // Tab moves from item to item, a digit answers a scale, and the last stop is Next.
  const auto scales = page().findChildren<OptionButtons*>();
  for (int presses = 0; presses < 200 && session.stepIndex() == questions; ++presses) {
    auto* focus = QApplication::focusWidget();
    ASSERT_NE(focus, nullptr);
    for (auto* scale : scales) {
      if (scale->isAncestorOf(focus) && scale->chosen() < 0) QTest::keyClick(focus, Qt::Key_4);
    }
    auto* next = qobject_cast<QPushButton*>(QApplication::focusWidget());
    if (next != nullptr && next->text() == QStringLiteral("Next")) {
      QTest::keyClick(next, Qt::Key_Space);
      break;
    }
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
  }
  EXPECT_EQ(session.stepIndex(), questions + 1);
}

/// The words of the participant's page about numbers, at each first trial of a block and at each
/// preference of a session of @p protocol.
std::vector<std::string> wordsAboutNumbers(const std::string& protocol) {
  const tests::ScratchFolder folder;
  SystemClock clock;
  questionnaires::Problems problems;
  auto study = Study::create(
      folder / "study",
      *protocols::loadProtocolFile(protocol, problems),
      clock,
      7,
      tests::knownSecret());
  OperatorWindow window(study);
  window.show();
  window.enrol({.cohort = "professional", .runMode = RunMode::Pilot, .language = "en", .code = {}});
  tests::Participant participant(window);
  participant.goTo(StepKind::Trial);
  const auto& session = window.controller()->session();
  std::vector<std::string> words;
  for (; !session.isOver(); window.controller()->skipStep(QStringLiteral("not needed here"))) {
    const auto& step = session.step();
    const bool isFirst = step.kind == StepKind::Trial && step.position == 1;
    if (!isFirst && step.kind != StepKind::Preference) continue;
    QCoreApplication::processEvents();  // shows the page
    words.emplace_back();
    for (const auto* label : window.participantWindow()->findChildren<QLabel*>()) {
      if (label->isVisible() && label->text().contains(QStringLiteral("numbers")))
        words.back() = label->text().toStdString();
    }
    if (!words.back().empty())
      tests::photograph(*window.participantWindow(), QStringLiteral("numbers"));
  }
  return words;
}

TEST(ParticipantNumbers, StartAgainInTheSecondBlockAndThePageSaysSo) {
  const auto words = wordsAboutNumbers("punch-counterbalanced");
  ASSERT_EQ(words.size(), 4U) << "two blocks, each with a preference";
  EXPECT_EQ(words[0], "");
  EXPECT_NE(words[1].find("in the order in which you felt them"), std::string::npos) << words[1];
  EXPECT_NE(words[1].find("in which the numbers start again."), std::string::npos) << words[1];
  EXPECT_EQ(
      words[2],
      "The numbers start again: Alternative 1 may now stand for something else than before.");
  EXPECT_NE(words[3].find("in the order in which you felt them"), std::string::npos) << words[3];
}

TEST(ParticipantNumbers, StayTheSameWhereEachConditionHasItsOwn) {
  const auto words = wordsAboutNumbers("punch-face-validity");
  ASSERT_EQ(words.size(), 4U);
  for (const std::size_t page : {0U, 2U, 3U}) EXPECT_EQ(words[page], "") << page;
  EXPECT_NE(words[1].find("with the same alternatives by the same numbers."), std::string::npos)
      << words[1];
}

/// The published study with an optional repetition of each alternative before the first choice.
class OptionalTrialPages : public testing::Test {
 protected:
  protocols::LoadedProtocol protocol() {
    questionnaires::Problems problems;
    const auto shipped = protocols::loadProtocolFile("punch-face-validity", problems);
    auto json = nlohmann::ordered_json::parse(shipped->text);
    for (auto& phase : json["phases"]) {
      if (phase["type"] == "preference") phase["feel_again"] = true;
    }
    return *protocols::loadProtocolFile(folder_.write("protocol.json", json.dump()), problems);
  }

  tests::ScratchFolder folder_;
  SystemClock clock_;
  Study study_{Study::create(folder_ / "study", protocol(), clock_, 7, tests::knownSecret())};
  OperatorWindow window_{study_};
  tests::Participant participant_{window_};
};

TEST_F(OptionalTrialPages, RepeatATrialOrSkipIt) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  const auto& session = window_.controller()->session();
  int offer = 0;
  while (!session.plan()[static_cast<std::size_t>(offer)].isOptionalTrial) ++offer;
  participant_.takePart(offer);
  ASSERT_EQ(session.stepIndex(), offer);
  participant_.look();
  auto* page = window_.participantWindow();
  QTest::mouseClick(tests::buttonSaying(page, QStringLiteral("No, go on")), Qt::LeftButton);
  EXPECT_EQ(session.stepIndex(), offer + 1);
  QCoreApplication::processEvents();
  QTest::mouseClick(tests::buttonSaying(page, QStringLiteral("Feel it again")), Qt::LeftButton);
  EXPECT_TRUE(window_.controller()->isTrialRunning());
  EXPECT_EQ(tests::buttonSaying(page, QStringLiteral("No, go on")), nullptr);
  window_.controller()->stop();
}

TEST(TrialPage, ClosesTheHandInTheTimeOfACutWhileTheSpaceBarIsHeld) {
  TrialPage page(
      {.name = QStringLiteral("Tissue 1"), .device = &haptics::devices::punchKind()}, nullptr);
  page.show();
  page.setRunning(true);
  double share = 0.0;
  QObject::connect(&page, &TrialPage::handMoved, [&](double told) { share = told; });
  auto& hand = *page.findChild<QVariantAnimation*>();
  // Time is that of the movement, not of a clock.
  const auto shareAfter = [&](int milliseconds) {
    hand.pause();
    hand.setCurrentTime(milliseconds);
    return share;
  };
  QTest::keyPress(&page, Qt::Key_Space);
  EXPECT_NEAR(shareAfter(120), 0.1, 0.02) << "ten units in 1.2 s, as in recorded cuts";
  EXPECT_NEAR(shareAfter(600), 0.5, 0.02);
  EXPECT_EQ(shareAfter(1200), 1.0);
  QTest::keyRelease(&page, Qt::Key_Space);
  EXPECT_LT(shareAfter(300), 1.0);
  EXPECT_GT(shareAfter(300), 0.0);
  EXPECT_EQ(shareAfter(hand.duration()), 0.0);
}

TEST_F(OptionalTrialPages, WriteACopyOfTheConsentOnRequest) {
  window_.show();
  window_.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  const auto code = window_.controller()->session().participant();
  const std::string pdf = folder_ / "copy.pdf";
  EXPECT_THROW(writeConsentCopy(study_, code, pdf), UserError) << "there is no consent yet";
  participant_.takePart(3);
  writeConsentCopy(study_, code, pdf);
  std::ifstream file(pdf, std::ios::binary);
  std::string head(5, ' ');
  file.read(head.data(), 5);
  EXPECT_EQ(head, "%PDF-");
  const auto left = copiesNotErased(study_, {}, code);
  ASSERT_EQ(left.size(), 1U) << "an erasure has to list it";
  EXPECT_EQ(left[0].what, "copied_consent");
  EXPECT_THROW(writeConsentCopy(study_, code, pdf), storage::StorageError) << "the file exists";
  EXPECT_EQ(copiesNotErased(study_, {}, code).size(), 1U) << "what was not written is not listed";
}

}  // namespace participant_window_test
}  // namespace study::gui
