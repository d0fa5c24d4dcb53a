#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include <QAction>
#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QLocale>
#include <QProgressBar>
#include <QTest>
#include <QTimer>

#include "protocols/load_protocol.h"
#include "study/cohort/simulated_participant.h"
#include "study/gui/authoring/texts_dialog.h"
#include "study/gui/desk/new_study_dialog.h"
#include "study/gui/desk/recent_studies.h"
#include "study/gui/home/home_window.h"
#include "study/gui/home/study_list.h"
#include "study/gui/home/study_panel.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/studio_settings.h"
#include "study/gui/widgets/written_file.h"
#include "study/session/arrivals.h"
#include "study/session/erasure.h"
#include "study/session/study_key.h"
#include "tests/study/gui/participant.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/known_secret.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace home_test {

using tests::buttonSaying;

protocols::LoadedProtocol shipped(const char* name) {
  questionnaires::Problems problems;
  return *protocols::loadProtocolFile(name, problems);
}

protocols::LoadedProtocol punchProtocol() {
  return shipped("punch-face-validity");
}

class HomeTest : public testing::Test {
 protected:
  void SetUp() override { studioSettings().clear(); }

  QString makeStudy(const std::string& name) {
    Study::create(folder_ / name, punchProtocol(), clock_, 7, tests::knownSecret());
    return QString::fromStdString(folder_ / name);
  }

  /// Creates a study whose program ended during a trial.
  QString makeCrashedStudy() {
    const QString folder = makeStudy("punch-study");
    auto study = Study::open(folder.toStdString(), clock_);
    OperatorWindow window(study);
    window.show();
    window.enrol({.cohort = "professional", .language = "en", .code = {}});
    tests::Participant participant(window);
    const auto& plan = window.controller()->session().plan();
    int trial = 0;
    while (plan[static_cast<std::size_t>(trial)].kind != StepKind::Trial) ++trial;
    participant.takePart(trial);
    window.controller()->session().beginTrial();
    return folder;
  }

  template <typename Widget>
  static Widget* shownWindow() {
    for (auto* window : QApplication::topLevelWidgets()) {
      auto* wanted = qobject_cast<Widget*>(window);
      if (wanted != nullptr && wanted->isVisible()) return wanted;
    }
    return nullptr;
  }

  static QTableWidget* listOf(HomeWindow& home) {
    return home.findChild<QTableWidget*>(QStringLiteral("studies"));
  }

  tests::ScratchFolder folder_;
  SystemClock clock_;
};

/// The texts of all buttons of @p window, with the letters that choose them with Alt.
QStringList buttonTexts(const QWidget& window) {
  QStringList texts;
  for (const auto* button : window.findChildren<QPushButton*>()) texts << button->text();
  texts.sort();
  return texts;
}

TEST_F(HomeTest, HasTheSameLettersWithAltAfterAChangeOfLanguageAsFromTheStart) {
  const auto shownAs = [](HomeWindow& home, const char* language) {
    setDeskLanguage(language);
    home.show();
    QTest::qWait(100);
    return buttonTexts(home);
  };
  HomeWindow changed;
  shownAs(changed, "en");
  const auto after = shownAs(changed, "de");
  HomeWindow german;
  EXPECT_EQ(after, shownAs(german, "de"));
  setDeskLanguage("en");
}

TEST_F(HomeTest, SpeaksTheLanguageThatIsChosenAndRemembersIt) {
  const QString folder = makeStudy("one");
  HomeWindow home;
  home.choose(folder);
  home.show();
  const auto choose = [&](const char* language) {
    for (auto* action : home.findChildren<QAction*>()) {
      if (action->objectName() == QStringLiteral("language-") + QLatin1String(language)) {
        action->trigger();
        return;
      }
    }
    ADD_FAILURE() << "no language " << language;
  };
  QLocale::setDefault(QLocale::German);
  choose("de");
  ASSERT_TRUE(QTest::qWaitFor([&] {
    return home.findChild<QPushButton*>(QStringLiteral("report"))->text() ==
           QStringLiteral("Bericht…");
  }));
  EXPECT_EQ(listOf(home)->rowCount(), 1);
  EXPECT_EQ(listOf(home)->currentRow(), 0);
  tests::photographInAllThemes(home, QStringLiteral("home-german"));
  setDeskLanguage("en");
  applyChosenLanguage();
  EXPECT_EQ(deskLanguage(), "de");
  EXPECT_EQ(QLocale().toString(201532.5, 'f', 1), QStringLiteral("201532.5"))
      << "fields have the point of sentences and files";
  setDeskLanguage("en");
}

TEST_F(HomeTest, SaysWhichSessionsOfAStationHaveArrivedAndWhyOthersHaveNot) {
  const tests::OwnStation account(folder_ / "account");
  {
    auto study = Study::create(
        folder_ / "oslo",
        punchProtocol(),
        clock_,
        7,
        tests::knownSecret(),
        {.site = "oslo", .label = "oslo", .uuid = "11"});
    SimulatedClock simulated;
    simulateCohorts(study, simulated, 2, 7, [](const auto&) {});
    recordPush(
        study.uuid(),
        "11",
        {.utc = "2026-11-17T09:00:00.000Z", .lastEvent = 0, .problem = "unreachable"});
  }
  HomeWindow home;
  home.choose(QString::fromStdString(folder_ / "oslo"));
  home.show();
  auto* label = home.findChild<QLabel*>(QStringLiteral("arrivals"));
  ASSERT_NE(label, nullptr);
  const QString words = label->text();
  EXPECT_EQ(
      words, QStringLiteral("Sessions here: 2. Arrived: 0. Waiting: 2 (no network, or no server)"))
      << "the times of simulated sessions are virtual";
  tests::photographInAllThemes(home, QStringLiteral("home-station"));
}

TEST_F(HomeTest, WarnsOfSessionsThatHaveBeenWaitingForADay) {
  StudySummary summary;
  summary.arrivals = Arrivals{.all = 23, .arrived = 21, .waitingSince = "2026-01-05T10:00:00.000Z"};
  summary.pushProblem = "full";
  StudyPanel panel;
  panel.show(summary);
  auto* label = panel.findChild<QLabel*>(QStringLiteral("arrivals"));
  EXPECT_EQ(
      label->text(),
      QStringLiteral("Sessions here: 23. Arrived: 21. Waiting since 2026-01-05: 2 (the server’s "
                     "disk is full)"));
  EXPECT_EQ(label->property("role").toString(), QStringLiteral("warn"));
  summary.arrivals = Arrivals{.all = 23, .arrived = 23, .waitingSince = {}};
  panel.show(summary);
  EXPECT_EQ(label->text(), QStringLiteral("Sessions here: 23. All have arrived"));
  EXPECT_EQ(label->property("role").toString(), QStringLiteral("body"));
}

TEST_F(HomeTest, OffersANewStudyIfThereIsNone) {
  HomeWindow home;
  home.show();
  EXPECT_EQ(listOf(home)->rowCount(), 0);
  EXPECT_FALSE(home.findChild<QPushButton*>(QStringLiteral("open"))->isEnabled());
  EXPECT_FALSE(listOf(home)->isVisible()) << "an empty table says nothing";
  std::set<QString> ways;
  for (const auto* button : home.findChildren<QPushButton*>()) {
    if (!button->isVisible()) continue;
    EXPECT_TRUE(ways.insert(button->text()).second) << button->text().toStdString() << " twice";
  }
  EXPECT_TRUE(ways.contains(QStringLiteral("New study…")));
  EXPECT_TRUE(ways.contains(QStringLiteral("Tour in three steps…")));
  tests::photographInAllThemes(home, QStringLiteral("home-empty"));
}

TEST_F(HomeTest, CreatesAStudyAfterItsProtocolWasCorrected) {
  std::string text;
  for (const auto& file : protocols::libraryFiles()) {
    if (file.name == "punch-face-validity.json") text = file.content;
  }
  const auto place = text.find("\"phases\"");
  ASSERT_NE(place, std::string::npos);
  const auto corrected = text;
  text.replace(place, 8, "\"phasen\"");
  const auto file = folder_.write("mine.json", text);

  HomeWindow home;
  home.show();
  QTest::mouseClick(buttonSaying(&home, QStringLiteral("New study…")), Qt::LeftButton);
  auto* dialog = shownWindow<NewStudyDialog>();
  ASSERT_NE(dialog, nullptr);
  tests::photographInAllThemes(*dialog, QStringLiteral("new-study"));
  dialog->setProtocolFile(QString::fromStdString(file));
  const QString folder = QString::fromStdString(folder_ / "made");
  dialog->findChild<PathField*>(QStringLiteral("folder"))->setPath(folder);
  auto* go = dialog->findChild<QPushButton*>(QStringLiteral("go"));
  EXPECT_FALSE(go->isEnabled());
  EXPECT_TRUE(dialog->findChild<NoteList*>(QStringLiteral("more"))
                  ->text()
                  .contains(checkProtocol(file).notes().front().text));
  EXPECT_EQ(
      dialog->findChild<QLabel*>(QStringLiteral("obstacle"))->text(),
      QStringLiteral("The protocol has errors."));
  tests::photographInAllThemes(*dialog, QStringLiteral("new-study-broken"));

  folder_.write("mine.json", corrected);
  ASSERT_TRUE(QTest::qWaitFor([&] { return go->isEnabled(); }));
  QTest::mouseClick(go, Qt::LeftButton);
  ASSERT_EQ(listOf(home)->rowCount(), 1);
  auto study = Study::open(folder.toStdString(), clock_);
  EXPECT_EQ(study.protocol().text, corrected);
  tests::photographInAllThemes(home, QStringLiteral("home"));
}

TEST_F(HomeTest, OpensTheOperatorWindowAndReturnsAfterwards) {
  HomeWindow home;
  home.show();
  home.choose(makeStudy("one"));
  QTest::mouseClick(home.findChild<QPushButton*>(QStringLiteral("open")), Qt::LeftButton);
  ASSERT_NE(home.operatorWindow(), nullptr);
  EXPECT_TRUE(home.operatorWindow()->isVisible());
  EXPECT_FALSE(home.isVisible());
  home.operatorWindow()->close();
  EXPECT_TRUE(home.isVisible());
  ASSERT_TRUE(QTest::qWaitFor([&] { return home.operatorWindow() == nullptr; }));
}

TEST_F(HomeTest, MarksAMissingStudyAndRemovesItOnRequest) {
  HomeWindow home;
  home.show();
  home.choose(makeStudy("one"));
  home.choose(makeStudy("two"));
  std::filesystem::remove_all(folder_ / "two");
  home.refresh();
  ASSERT_EQ(listOf(home)->rowCount(), 2);
  EXPECT_TRUE(listOf(home)->item(0, 0)->text().contains(QStringLiteral("gone")));
  listOf(home)->selectRow(0);
  EXPECT_FALSE(home.findChild<QPushButton*>(QStringLiteral("open"))->isEnabled());
  EXPECT_TRUE(home.findChild<QLabel*>(QStringLiteral("problem"))->isVisible());
  tests::photographInAllThemes(home, QStringLiteral("home-gone"));
  QTest::mouseClick(home.findChild<QPushButton*>(QStringLiteral("forget")), Qt::LeftButton);
  EXPECT_EQ(listOf(home)->rowCount(), 1);
}

TEST_F(HomeTest, ListsTheLastOpenedStudyFirstAlsoAfterARestart) {
  const QString one = makeStudy("one");
  const QString two = makeStudy("two");
  {
    HomeWindow home;
    home.choose(one);
    home.choose(two);
    home.choose(one);
  }
  const auto recent = recentStudies();
  ASSERT_EQ(recent.size(), 2U);
  EXPECT_EQ(recent[0].folder, one);
  EXPECT_EQ(recent[1].folder, two);
}

TEST_F(HomeTest, ListsEveryStudyAndReadsOnlyThoseInSight) {
  constexpr int kStudies = 200;
  constexpr int kPatience = 60'000;  // [ms]
  for (int i = 0; i < kStudies; ++i) {
    addRecentStudy(
        QString::fromStdString(folder_ / std::to_string(i)), QStringLiteral("Study %1").arg(i));
  }
  HomeWindow home;
  home.show();
  const auto* list = listOf(home);
  ASSERT_EQ(list->rowCount(), kStudies);
  const auto isRead = [&](int row) { return !list->item(row, 0)->text().endsWith(u'…'); };
  const auto readRows = [&] {
    int read = 0;
    for (int row = 0; row < kStudies; ++row) read += isRead(row) ? 1 : 0;
    return read;
  };
  EXPECT_EQ(readRows(), 1) << "the chosen one; the others wait until the window is there";
  ASSERT_TRUE(QTest::qWaitFor([&] { return isRead(2); }, kPatience));
  EXPECT_FALSE(isRead(kStudies - 1));
  listOf(home)->scrollToBottom();
  ASSERT_TRUE(QTest::qWaitFor([&] { return isRead(kStudies - 1); }, kPatience));
  EXPECT_LT(readRows(), kStudies / 2);
}

TEST_F(HomeTest, CountsLiveParticipantsOnlyForTheNumberPlanned) {
  const QString folder = makeStudy("one");
  {
    SimulatedClock clock;
    auto study = Study::open(folder.toStdString(), clock);
    simulateCohorts(study, clock, 2, 7, [](const auto&) {});
    Session::enrol(study, {.cohort = "professional", .runMode = RunMode::Pilot});
  }
  const auto summary = summaryOf(folder.toStdString());
  ASSERT_EQ(summary.cohorts.size(), 2U);
  for (const auto& cohort : summary.cohorts) EXPECT_EQ(cohort.completed, 0) << cohort.title;
  const auto words = sessionsInWords(summary);
  EXPECT_NE(words.find("Pilot: 0 of 1 completed"), std::string::npos) << words;
  EXPECT_NE(words.find("Simulated: 2 of 2 completed"), std::string::npos) << words;
  EXPECT_EQ(defaultRunMode(summary), RunMode::Pilot) << "people come before simulated participants";
}

TEST_F(HomeTest, DoesNotCountAnErasedParticipant) {
  const QString folder = makeStudy("one");
  {
    auto study = Study::open(folder.toStdString(), clock_);
    Session::enrol(study, {.cohort = "professional", .runMode = RunMode::Pilot});
    erase(
        study,
        {.participant = "PILOT-001", .level = storage::ErasureLevel::All, .reason = "asked"});
  }
  EXPECT_EQ(sessionsInWords(summaryOf(folder.toStdString())), "no sessions yet");
}

TEST_F(HomeTest, OffersWhatIsStillToBeDoneBesideASentence) {
  StudyPanel panel;
  int asked = 0;
  QObject::connect(&panel, &StudyPanel::textsRequested, &panel, [&] { ++asked; });
  panel.show(StudySummary{.blanks = 10});
  EXPECT_EQ(
      panel.findChild<QLabel*>(QStringLiteral("texts-remark"))->text(),
      QStringLiteral("10 texts are still blank."));
  panel.findChild<QPushButton*>(QStringLiteral("texts-remark-button"))->click();
  EXPECT_EQ(asked, 1);
  panel.show(StudySummary{});
  EXPECT_TRUE(panel.findChild<QLabel*>(QStringLiteral("texts-remark"))->parentWidget()->isHidden());
}

TEST_F(HomeTest, ShowsHowFarEachCohortHasComeAndWhatWasWritten) {
  const QString folder = makeStudy("one");
  {
    SimulatedClock clock;
    auto study = Study::open(folder.toStdString(), clock);
    simulateCohorts(study, clock, 2, 7, [](const auto&) {});
  }
  const auto report = folder_.write("report.html", "a report");
  rememberDocument(folder, QString::fromStdString(report));
  rememberDocument(folder, QString::fromStdString(folder_ / "gone.html"));
  HomeWindow home;
  home.resize(1240, 900);
  home.show();
  home.choose(folder);
  const auto summary = summaryOf(folder.toStdString());
  ASSERT_EQ(summary.cohorts.size(), 2U);
  EXPECT_TRUE(summary.lastSessionUtc.empty()) << "simulated sessions have a time of their own";
  EXPECT_EQ(summary.blanks, 10U);
  EXPECT_EQ(home.findChildren<QProgressBar*>().size(), 2);
  EXPECT_EQ(listOf(home)->item(0, 0)->data(StudyList::kShareRole), QVariant(0.0))
      << "the bar in the list";
  const auto documents = home.findChildren<WrittenFile*>();
  ASSERT_EQ(documents.size(), 1) << "a file that is gone is not offered";
  EXPECT_EQ(documents.front()->path().toStdString(), report);
  tests::photographInAllThemes(home, QStringLiteral("home-progress"));
}

TEST_F(HomeTest, FillsInTheTextsOfAStudyOnce) {
  const QString folder = makeStudy("one");
  HomeWindow home;
  home.show();
  home.choose(folder);
  QTimer fill;
  QObject::connect(&fill, &QTimer::timeout, &fill, [&] {
    auto* form = qobject_cast<TextsDialog*>(QApplication::activeModalWidget());
    if (form == nullptr) return;
    fill.stop();
    EXPECT_EQ(form->findChild<QLineEdit*>(QStringLiteral("text-duration"))->text().toInt() % 5, 0)
        << "from the timeline";
    form->findChild<QLineEdit*>(QStringLiteral("text-institution"))->setText(QStringLiteral("Lab"));
    auto* languages = form->findChild<QComboBox*>(QStringLiteral("language"));
    languages->setCurrentIndex(languages->findData(QStringLiteral("de")));
    form->findChild<QLineEdit*>(QStringLiteral("text-institution"))
        ->setText(QStringLiteral("Labor"));
    tests::photographInAllThemes(*form, QStringLiteral("texts"));
    QTest::mouseClick(form->findChild<QPushButton*>(QStringLiteral("save")), Qt::LeftButton);
  });
  fill.start(20);
  QTest::mouseClick(home.findChild<QPushButton*>(QStringLiteral("texts")), Qt::LeftButton);
  auto study = Study::open(folder.toStdString(), clock_);
  EXPECT_EQ(study.protocols().all().size(), 2U) << "an amendment";
  const auto& consent = study.protocol().instrument("consent-punch-2")->introduction;
  EXPECT_NE(consent.in("en").find("on a computer of Lab for "), std::string::npos);
  EXPECT_NE(consent.in("de").find("auf einem Computer von Labor"), std::string::npos);
  EXPECT_EQ(summaryOf(folder.toStdString()).blanks, 8U) << "institution and duration are there";
}

TEST_F(HomeTest, HasTheButtonThatContinuesInSightOnASmallScreen) {
  const auto study = makeCrashedStudy();
  for (const std::string language : {"en", "de", "nb"}) {
    setDeskLanguage(language);
    HomeWindow home;
    home.resize(1024, 700);
    home.show();
    home.choose(study);
    QTest::qWait(1);  // the window's layout is done in the event loop
    const auto* tasks = home.findChild<QPushButton*>(QStringLiteral("report"))->parentWidget();
    EXPECT_TRUE(QTest::qWaitFor([&] { return tasks->height() >= tasks->sizeHint().height(); }))
        << language << ": they are squeezed";
    const auto* card = home.findChild<QFrame*>(QStringLiteral("unfinished-P001"));
    ASSERT_NE(card, nullptr);
    for (const auto* button : card->findChildren<QPushButton*>()) {
      EXPECT_EQ(button->visibleRegion().boundingRect().size(), button->size())
          << language << ": " << button->text().toStdString();
    }
    tests::photograph(home, QStringLiteral("home-unfinished-") + QString::fromStdString(language));
  }
  setDeskLanguage("en");
}

TEST_F(HomeTest, SaysHowFarAStudyHasComeOnADayOfSessions) {
  const QString folder = QString::fromStdString(folder_ / "punch-study");
  {
    auto study = Study::create(
        folder.toStdString(), tests::filledIn(punchProtocol()), clock_, 7, tests::knownSecret());
    exportKey(study, folder_ / "key.json", "kept apart");
    for (const char* cohort : {"professional", "non-professional", "professional"}) {
      auto session = tests::consenting(study, {.cohort = cohort});
      tests::walkToTheEnd(session);
    }
    auto interrupted = tests::consenting(study, {.cohort = "non-professional"});
    tests::walkTo(interrupted, StepKind::Trial);
  }
  const QString other = QString::fromStdString(folder_ / "counterbalanced-pilot");
  {
    SimulatedClock clock;
    auto study = Study::create(
        other.toStdString(), shipped("punch-counterbalanced"), clock, 7, tests::knownSecret());
    simulateCohorts(study, clock, 4, 7, [](const auto&) {});
  }
  for (const char* name : {"punch-report.pdf", "punch-export"}) {
    rememberDocument(folder, QString::fromStdString(folder_.write(name, "written")));
  }
  HomeWindow home;
  home.resize(1240, 860);
  home.show();
  home.choose(other);
  home.choose(folder);
  EXPECT_EQ(sessionsInWords(summaryOf(folder.toStdString())), "3 of 11 completed · 1 unfinished");
  EXPECT_EQ(listOf(home)->item(0, 0)->data(StudyList::kShareRole).toDouble(), 3.0 / 11.0)
      << "the bar shows what the words say";
  QCoreApplication::processEvents();
  const auto* remark = home.findChild<QLabel*>(QStringLiteral("blinding-remark"));
  EXPECT_TRUE(remark->isVisible()) << "a report would tell conditions to who runs P004";
  const auto* make = home.findChild<QPushButton*>(QStringLiteral("new-study"));
  const int end = listOf(home)->mapTo(&home, QPoint(0, listOf(home)->height())).y();
  EXPECT_LT(make->mapTo(&home, QPoint(0, 0)).y() - end, 40) << "right below two studies";
  tests::photographInAllThemes(home, QStringLiteral("home-day"));
}

TEST_F(HomeTest, BeginsAtTheButtonForANewStudy) {
  HomeWindow home;
  home.show();
  home.activateWindow();
  ASSERT_TRUE(QTest::qWaitForWindowActive(&home));
  auto* focused = qobject_cast<QPushButton*>(home.focusWidget());
  ASSERT_NE(focused, nullptr);
  EXPECT_EQ(focused->property("role").toString(), QStringLiteral("main"));
}

TEST_F(HomeTest, OffersToResumeAfterACrash) {
  HomeWindow home;
  home.resize(1240, 900);
  home.show();
  home.choose(makeCrashedStudy());
  EXPECT_TRUE(listOf(home)->item(0, 0)->text().contains(QStringLiteral("1 unfinished")));
  auto* card = home.findChild<QFrame*>(QStringLiteral("unfinished-P001"));
  ASSERT_NE(card, nullptr);
  QCoreApplication::processEvents();  // the window's layout is done in the event loop
  auto* details = card->findChild<QPushButton*>(QStringLiteral("details"));
  const auto shown = [&] {
    QString words;
    for (auto* label : card->findChildren<QLabel*>()) {
      if (label->isVisible()) words += label->text();
    }
    return words;
  };
  EXPECT_EQ(shown(), QStringLiteral("Unfinished: P001 (live), step 5 of 19."));
  QTest::mouseClick(details, Qt::LeftButton);
  EXPECT_TRUE(shown().contains(QStringLiteral("What was felt until then is kept")));
  details->toggle();
  QString words;
  for (auto* label : card->findChildren<QLabel*>()) words += label->text();
  EXPECT_TRUE(words.contains(QStringLiteral("Repeat the trial"))) << words.toStdString();
  EXPECT_TRUE(words.contains(QStringLiteral("Device failed: end it"))) << words.toStdString();
  tests::photographInAllThemes(home, QStringLiteral("home-crashed"));
  QTest::mouseClick(buttonSaying(card, QStringLiteral("Continue with P001")), Qt::LeftButton);
  ASSERT_NE(home.operatorWindow(), nullptr);
  ASSERT_NE(home.operatorWindow()->controller(), nullptr);
  EXPECT_EQ(home.operatorWindow()->controller()->session().state(), SessionState::Interrupted);
  home.operatorWindow()->close();
  ASSERT_TRUE(QTest::qWaitFor([&] { return home.operatorWindow() == nullptr; }));
}

}  // namespace home_test
}  // namespace study::gui
