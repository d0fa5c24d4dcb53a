#include "study/gui/desk/study_dialogs.h"

#include <algorithm>
#include <filesystem>
#include <set>

#include <gtest/gtest.h>

#include <QApplication>
#include <QCheckBox>
#include <QClipboard>
#include <QComboBox>
#include <QDate>
#include <QFileInfo>
#include <QLineEdit>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QTimer>

#include "protocols/load_protocol.h"
#include "study/cohort/simulated_participant.h"
#include "study/export/public_tables.h"
#include "study/gui/desk/erase_dialog.h"
#include "study/gui/desk/export_dialog.h"
#include "study/gui/desk/recent_studies.h"
#include "study/gui/desk/task_dialogs.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/result_view.h"
#include "study/gui/widgets/written_file.h"
#include "study/model/clock.h"
#include "study/report/study_parts.h"
#include "study/report/tables/plan_tables.h"
#include "study/report/tables/statistics_tables.h"
#include "study/results/study_plan.h"
#include "study/words/words.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/known_secret.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace study_dialogs_test {

/// A study with eight simulated participants, made once for all tests.
class StudyDialogsTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    made = new tests::ScratchFolder;
    questionnaires::Problems problems;
    const auto protocol = *protocols::loadProtocolFile("punch-face-validity", problems);
    SimulatedClock clock;
    auto study = Study::create(*made / "study", protocol, clock, 7, tests::knownSecret());
    simulateCohorts(study, clock, 8, 7, [](const auto&) {});
  }
  static void TearDownTestSuite() { delete made; }

  std::string study() const { return *made / "study"; }
  StudySummary summary() const { return summaryOf(study()); }

  /// Enters the target, presses the button and waits for the end.
  static void press(QDialog& dialog, const std::string& target = {}) {
    dialog.show();
    if (auto* field = dialog.findChild<PathField*>())
      field->setPath(QString::fromStdString(target));
    QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("go")), Qt::LeftButton);
  }
  static QString outcome(QDialog& dialog) {
    return dialog.findChild<QLabel*>(QStringLiteral("outcome"))->text();
  }
  static QString more(QDialog& dialog) {
    return dialog.findChild<NoteList*>(QStringLiteral("more"))->text();
  }

  static inline tests::ScratchFolder* made = nullptr;
  tests::ScratchFolder out_;
};

TEST_F(StudyDialogsTest, VerifyListsEveryCheck) {
  VerifyDialog dialog(summary());
  press(dialog);
  EXPECT_TRUE(outcome(dialog).startsWith(QStringLiteral("✓"))) << outcome(dialog).toStdString();
  EXPECT_EQ(more(dialog).count(QStringLiteral("✓")), 10);
  EXPECT_TRUE(outcome(dialog).contains(QStringLiteral("Not everything can be proven")))
      << "no station has signed anything of it yet";
  QTest::qWait(1);  // sizes follow what is shown
  EXPECT_EQ(dialog.findChild<QScrollArea*>()->verticalScrollBar()->maximum(), 0);
  tests::photographInAllThemes(dialog, QStringLiteral("verify"));
}

TEST_F(StudyDialogsTest, VerifyNotesThatABackupWasPutBackOnPurpose) {
  namespace fs = std::filesystem;
  SystemClock clock;
  const tests::OwnStation station(out_ / "station");  // of the others, no study has a branch
  const auto folder = out_ / "study";
  fs::copy(study(), folder, fs::copy_options::recursive);
  const auto noted = [&](const std::string& from) {
    Study::open(from, clock).note(EventKind::UnblindedResults, "an interim look");
  };
  noted(folder);
  fs::copy(folder, out_ / "older", fs::copy_options::recursive);
  noted(folder);
  fs::remove_all(folder);
  fs::rename(out_ / "older", folder);
  VerifyDialog dialog(summaryOf(folder));
  press(dialog);
  EXPECT_EQ(
      outcome(dialog),
      QStringLiteral("!  This is an older copy of the study. What it has is undamaged."));
  EXPECT_FALSE(more(dialog).contains(QStringLiteral("✕"))) << more(dialog).toStdString();
  auto* restored = dialog.findChild<QPushButton*>(QStringLiteral("restored"));
  ASSERT_TRUE(restored->isVisible());
  QTimer::singleShot(0, &dialog, [] {
    auto* question = qobject_cast<MessageBox*>(QApplication::activeModalWidget());
    ASSERT_NE(question, nullptr);
    question->setText(QStringLiteral("the disk failed"));
    question->accept();
  });
  QTest::mouseClick(restored, Qt::LeftButton);
  EXPECT_TRUE(outcome(dialog).startsWith(QStringLiteral("✓"))) << more(dialog).toStdString();
  EXPECT_FALSE(restored->isVisible());
}

TEST(StudyDialogs, ProposeAnotherDiskForCopiesWhereOneCanBeWrittenTo) {
  const auto proposed = [](const QString& root, const char* device, bool isWritable) {
    return diskApartFrom(
        "/dev/sda1", {{QStringLiteral("/"), "/dev/sda2", true}, {root, device, isWritable}});
  };
  const auto stick = QStringLiteral("/media/anna/STICK");
  EXPECT_EQ(proposed(stick, "/dev/sdb1", true), stick);
  EXPECT_EQ(proposed(QStringLiteral("/mnt"), "/dev/sdb1", true), QStringLiteral("/mnt"));
  EXPECT_EQ(proposed(stick, "/dev/sdb1", false), QString());
  EXPECT_EQ(proposed(stick, "/dev/sda1", true), QString()) << "the disk of the study";
  EXPECT_EQ(proposed(QStringLiteral("/boot/efi"), "/dev/sdb1", true), QString());
}

TEST_F(StudyDialogsTest, BackupMakesAValidCopy) {
  BackupDialog dialog(summary());
  press(dialog, out_ / "copy");
  EXPECT_TRUE(outcome(dialog).startsWith(QStringLiteral("✓"))) << outcome(dialog).toStdString();
  EXPECT_EQ(dialog.findChild<QLabel*>(QStringLiteral("obstacle"))->text(), QString())
      << "nothing failed";
  SystemClock clock;
  auto copy = Study::open(out_ / "copy", clock, storage::Database::Access::ReadOnly);
  EXPECT_TRUE(verify(copy).isSound());
  tests::photographInAllThemes(dialog, QStringLiteral("backup"));
}

TEST_F(StudyDialogsTest, ReportIsWrittenAsHtmlAndPdf) {
  for (const std::string name : {"report.html", "report.pdf"}) {
    ReportDialog dialog(summary());
    press(dialog, out_ / name);
    EXPECT_TRUE(outcome(dialog).startsWith(QStringLiteral("✓"))) << outcome(dialog).toStdString();
    EXPECT_GT(std::filesystem::file_size(out_ / name), 10'000U);
  }
  EXPECT_EQ(tests::contentOf(out_ / "report.pdf").substr(0, 5), "%PDF-");
}

TEST_F(StudyDialogsTest, ReportCanBeOpenedAndWrittenAgain) {
  ReportDialog dialog(summary());
  press(dialog, out_ / "report.html");
  const auto* written = dialog.findChild<WrittenFile*>();
  EXPECT_TRUE(written->isVisible());
  EXPECT_EQ(written->path().toStdString(), out_ / "report.html");
  const auto next = dialog.findChild<PathField*>()->path();
  EXPECT_TRUE(next.contains(QDate::currentDate().toString(Qt::ISODate))) << next.toStdString();
  EXPECT_FALSE(QFileInfo::exists(next)) << "Write would fail";
  ASSERT_FALSE(documentsOf(QString::fromStdString(study())).empty());
  EXPECT_EQ(
      documentsOf(QString::fromStdString(study())).front().path.toStdString(),
      out_ / "report.html");
}

TEST_F(StudyDialogsTest, ReportHasPagesOfLetterSizeAndNoQuotesIfAsked) {
  ReportDialog dialog(summary());
  auto* paper = dialog.findChild<QComboBox*>(QStringLiteral("paper"));
  paper->setCurrentIndex(paper->findText(QStringLiteral("Letter")));
  press(dialog, out_ / "report.pdf");
  // Letter is 612×792 pt, A4 595×842 pt.
  EXPECT_NE(tests::contentOf(out_ / "report.pdf").find("/MediaBox [0 0 612.0"), std::string::npos);

  auto* quotes = dialog.findChild<QCheckBox*>(QStringLiteral("quotes"));
  press(dialog, out_ / "with.html");
  quotes->setChecked(false);
  press(dialog, out_ / "without.html");
  EXPECT_LT(
      tests::contentOf(out_ / "without.html").size(), tests::contentOf(out_ / "with.html").size());
}

TEST_F(StudyDialogsTest, StatisticsAnswerFirstAndThenShowTheDeclaredTests) {
  StatisticsDialog dialog(summary());
  press(dialog);
  SystemClock clock;
  auto study = Study::open(this->study(), clock, storage::Database::Access::ReadOnly);
  const auto section = report::gather(study, RunMode::Simulated);
  const auto wordsOf = [&](const char* name) {
    return dialog.findChild<QLabel*>(QString::fromUtf8(name))->text().toStdString();
  };
  EXPECT_EQ(wordsOf("finding") + " " + wordsOf("more-of-answer"), report::verdictOf(section));
  EXPECT_NE(wordsOf("notice").find("nobody took part"), std::string::npos);
  auto& view = *dialog.findChild<ResultView*>();
  EXPECT_TRUE(dialog.findChild<NoteList*>(QStringLiteral("caveats"))
                  ->text()
                  .contains(QStringLiteral("take all answers of a person as")))
      << "two rounds, pooled";
  EXPECT_TRUE(dialog.findChild<NoteList*>(QStringLiteral("caveats"))
                  ->text()
                  .contains(QStringLiteral("not adjusted for several")));
  const auto* rows = dialog.findChild<QTableWidget*>(QStringLiteral("results"));
  EXPECT_LT(rows->rowHeight(2), rows->rowHeight(1)) << "a row of one line";
  const auto expected = report::statisticsTables(section, Profile::Declared);
  EXPECT_EQ(asCsv(view.table()), asCsv(expected.front()));
  EXPECT_EQ(view.table().rows.size(), 6U) << "three pairs in each of two cohorts";
  const auto* cells = dialog.findChild<QTableWidget*>(QStringLiteral("results"));
  EXPECT_EQ(cells->rowCount(), 8) << "each cohort is named once, above its rows";
  EXPECT_EQ(cells->item(1, 5)->textAlignment() & Qt::AlignHorizontal_Mask, Qt::AlignRight);
  const auto* p = cells->horizontalHeaderItem(7);
  EXPECT_EQ(p->text(), QStringLiteral("p")) << "before what it says in words";
  tests::photographInAllThemes(dialog, QStringLiteral("statistics"));
}

TEST_F(StudyDialogsTest, StatisticsAreScrolledByOneScrollBarAtMost) {
  StatisticsDialog dialog(summary());
  press(dialog);
  const auto* page = dialog.findChild<QScrollArea*>()->verticalScrollBar();
  const auto* table = dialog.findChild<QTableWidget*>(QStringLiteral("results"));
  const auto* rows = table->verticalScrollBar();
  for (const QSize size : {QSize(683, 384), QSize(1024, 700), QSize(1240, 960)}) {
    dialog.resize(size);
    QTest::qWait(1);  // sizes follow what is shown
    EXPECT_TRUE(page->maximum() == 0 || rows->maximum() == 0) << size.width();
  }
  EXPECT_EQ(page->maximum() + rows->maximum(), 0) << "all is in sight";
  EXPECT_EQ(table->horizontalScrollBar()->maximum(), 0);
}

TEST_F(StudyDialogsTest, StatisticsShowExploratoryTestsOnlyWhereAsked) {
  StatisticsDialog dialog(summary());
  press(dialog);
  auto& view = *dialog.findChild<ResultView*>();
  const auto csv = [&] { return asCsv(view.table()); };
  EXPECT_EQ(csv().find("Exploratory."), std::string::npos) << csv();
  for (auto* choice : dialog.findChildren<QComboBox*>()) {
    const auto within = choice->findData(static_cast<int>(Profile::Recommended));
    if (choice->accessibleName() == QStringLiteral("Which tests")) choice->setCurrentIndex(within);
  }
  EXPECT_NE(csv().find("Exploratory."), std::string::npos) << csv();
  tests::photographInAllThemes(dialog, QStringLiteral("statistics-within"));
}

TEST_F(StudyDialogsTest, StatisticsAreCopiedAndSaved) {
  StatisticsDialog dialog(summary());
  press(dialog);
  auto* cells = dialog.findChild<QTableWidget*>(QStringLiteral("results"));
  QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("copy")), Qt::LeftButton);
  const auto whole = QApplication::clipboard()->text();
  EXPECT_EQ(whole.count(u'\n'), 7) << whole.toStdString();
  EXPECT_TRUE(whole.startsWith(QStringLiteral("Cohort\tComparison\tAnswers\tPeople\t")))
      << whole.toStdString();
  cells->setFocus();
  cells->selectRow(1);
  QTest::keySequence(cells, QKeySequence::Copy);
  const auto row = QApplication::clipboard()->text();
  EXPECT_EQ(row.count(u'\n'), 1) << row.toStdString();
  EXPECT_TRUE(row.contains(cells->item(1, 1)->text())) << row.toStdString();
  const auto& view = *dialog.findChild<ResultView*>();
  view.saveTo(QString::fromStdString(out_ / "table.csv"));
  const auto asShown = QString::fromStdString(asCsv(view.table()));
  ASSERT_TRUE(asShown.contains(u'−')) << "the minus sign of people";
  EXPECT_EQ(
      tests::contentOf(out_ / "table.csv"), QString(asShown).replace(u'−', u'-').toStdString())
      << "that of programs";
  EXPECT_ANY_THROW(view.saveTo(QString::fromStdString(out_ / "table.csv")))
      << "nothing is overwritten";
}

TEST_F(StudyDialogsTest, StatisticsOfOneCohortSayThatTheOtherHasNoAnswers) {
  questionnaires::Problems problems;
  const auto protocol = *protocols::loadProtocolFile("punch-face-validity", problems);
  SimulatedClock clock;
  auto study = Study::create(out_ / "begun", protocol, clock, 7, tests::knownSecret());
  simulateCohorts(study, clock, 1, 7, [](const auto&) {});
  const auto section = report::gather(study, RunMode::Simulated);
  ResultView view;
  ASSERT_NO_THROW(view.show({}, report::statisticsTables(section, Profile::Declared)));
  EXPECT_NE(asCsv(view.table()).find("No answers yet."), std::string::npos);
}

TEST_F(StudyDialogsTest, ResultsWithoutATableCanNeitherBeCopiedNorSaved) {
  ResultView view;
  const auto shows = [&](const char* name) {
    return view.findChild<QWidget*>(QString::fromUtf8(name))->isVisibleTo(&view);
  };
  view.show({"Nothing can be compared."}, {});
  for (const auto* part : {"table", "copy", "save", "results"}) EXPECT_FALSE(shows(part)) << part;
  const DataTable one{.name = "one", .description = "One", .columns = {{"a"}}, .rows = {}};
  view.show({}, {one, one});
  for (const auto* part : {"table", "copy", "save", "results"}) EXPECT_TRUE(shows(part)) << part;
  view.show({}, {one});
  EXPECT_FALSE(shows("table")) << "there is nothing to choose";
}

TEST_F(StudyDialogsTest, SimulationAddsParticipants) {
  questionnaires::Problems problems;
  const auto protocol = *protocols::loadProtocolFile("two-devices", problems);
  SystemClock clock;
  Study::create(out_ / "other", protocol, clock, 7);
  SimulateDialog dialog(summaryOf(out_ / "other"));
  dialog.findChild<QSpinBox*>(QStringLiteral("participants"))->setValue(2);
  dialog.show();
  QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("go")), Qt::LeftButton);
  EXPECT_TRUE(outcome(dialog).startsWith(QStringLiteral("✓"))) << outcome(dialog).toStdString();
  EXPECT_EQ(summaryOf(out_ / "other").completed.at(RunMode::Simulated), 2);
}

TEST_F(StudyDialogsTest, SayEveryCheckOfAVerificationInEveryLanguage) {
  SystemClock clock;
  auto opened = Study::open(study(), clock, storage::Database::Access::ReadOnly);
  const auto verification = verify(opened);
  for (const std::string language : {"de", "nb"}) {
    const auto words = words::wordsIn(language);
    for (const auto& check : verification.checks) {
      EXPECT_TRUE(words.catalogue().desk.contains(check.what)) << language << ": " << check.what;
    }
  }
}

TEST_F(StudyDialogsTest, OfferAReportInTheLanguageOfTheDesk) {
  setDeskLanguage("de");
  ReportDialog dialog(summary());
  const auto boxes = dialog.findChildren<QComboBox*>();
  EXPECT_TRUE(std::ranges::any_of(boxes, [](const QComboBox* box) {
    return box->currentData() == QVariant(QStringLiteral("de"));
  }));
  setDeskLanguage("en");
}

TEST_F(StudyDialogsTest, SayWhyTheyCannotStart) {
  const auto expectObstacle = [](QDialog& dialog, const char* words) {
    EXPECT_FALSE(dialog.findChild<QPushButton*>(QStringLiteral("go"))->isEnabled()) << words;
    EXPECT_EQ(dialog.findChild<QLabel*>(QStringLiteral("obstacle"))->text().toStdString(), words);
  };
  ReportDialog report(summary());
  StatisticsDialog statistics(summary());
  ExportDialog data(summary());
  for (QDialog* dialog :
       {static_cast<QDialog*>(&report),
        static_cast<QDialog*>(&statistics),
        static_cast<QDialog*>(&data)}) {
    EXPECT_TRUE(dialog->findChild<QPushButton*>(QStringLiteral("go"))->isEnabled());
    for (auto* choice : dialog->findChildren<QComboBox*>()) {
      const int live = choice->findData(static_cast<int>(RunMode::Live));
      if (choice->accessibleName() == QStringLiteral("Which sessions"))
        choice->setCurrentIndex(live);
    }
    expectObstacle(*dialog, "There are no such sessions yet.");
  }
  BackupDialog backup(summary());
  backup.findChild<PathField*>()->setPath(QString());
  expectObstacle(backup, "Choose a new folder.");
}

TEST_F(StudyDialogsTest, ReportOfLiveSessionsNeedsAReason) {
  auto study = summary();
  study.sessions[RunMode::Live] = 1;
  ReportDialog dialog(study);
  dialog.show();
  auto* go = dialog.findChild<QPushButton*>(QStringLiteral("go"));
  auto* reason = dialog.findChild<QLineEdit*>(QStringLiteral("reason"));
  const auto choose = [&](RunMode mode) {
    for (auto* choice : dialog.findChildren<QComboBox*>()) {
      if (choice->accessibleName() != QStringLiteral("Which sessions")) continue;
      choice->setCurrentIndex(choice->findData(static_cast<int>(mode)));
    }
  };
  choose(RunMode::Simulated);
  EXPECT_TRUE(go->isEnabled()) << "simulated sessions need no reason";
  EXPECT_FALSE(reason->isVisible());
  choose(RunMode::Live);
  EXPECT_TRUE(reason->isVisible());
  EXPECT_FALSE(go->isEnabled());
  reason->setText(QStringLiteral("plan signed"));
  EXPECT_TRUE(go->isEnabled());
}

TEST_F(StudyDialogsTest, ReportIsNotScrolledWithOrWithoutAReason) {
  ReportDialog dialog(summary());
  dialog.show();
  const auto* bar = dialog.findChild<QScrollArea*>()->verticalScrollBar();
  for (const auto mode : {RunMode::Simulated, RunMode::Live, RunMode::Simulated}) {
    for (auto* choice : dialog.findChildren<QComboBox*>()) {
      const int index = choice->findData(static_cast<int>(mode));
      if (choice->accessibleName() != QStringLiteral("Which sessions")) continue;
      choice->setCurrentIndex(index);
    }
    QTest::qWait(1);  // sizes follow what is shown
    EXPECT_EQ(bar->maximum(), 0) << nameOf(mode);
  }
}

TEST_F(StudyDialogsTest, ReportWritesFiguresInTheSizeOfAJournal) {
  const std::string study = out_ / "study";
  std::filesystem::copy(this->study(), study);
  ReportDialog dialog(summaryOf(study));
  auto* width = dialog.findChild<QSpinBox*>(QStringLiteral("figure-width"));
  dialog.show();
  EXPECT_FALSE(width->isVisible());
  dialog.findChild<QCheckBox*>(QStringLiteral("figures"))->setChecked(true);
  EXPECT_TRUE(width->isVisible());
  width->setValue(120);
  press(dialog, out_ / "report.html");
  const auto written = dialog.findChildren<WrittenFile*>();
  EXPECT_TRUE(std::any_of(written.begin(), written.end(), [](const WrittenFile* each) {
    return each->isVisible() && QFileInfo(each->path()).isDir();
  })) << "the figures' folder can be opened, too";
  EXPECT_TRUE(outcome(dialog).contains(QStringLiteral("; figures: ")))
      << outcome(dialog).toStdString();
  const std::filesystem::path folder =
      study + "-figures-" + QDate::currentDate().toString(Qt::ISODate).toStdString();
  const auto svg = tests::contentOf(folder / "punch-face-validity-felt.svg");
  EXPECT_NE(svg.find("width=\"120.000mm\""), std::string::npos) << svg.substr(0, 200);
}

TEST_F(StudyDialogsTest, PlanSaysFirstWhatTheStudyCanFind) {
  PlanDialog dialog(summary());
  dialog.findChild<QSpinBox*>(QStringLiteral("participants"))->setValue(12);
  press(dialog);
  questionnaires::Problems problems;
  const auto protocol = *protocols::loadProtocolFile("punch-face-validity", problems);
  const auto plan = planOf(protocol, {.participants = 12});
  const auto answer = report::planInWords(plan);
  EXPECT_EQ(
      dialog.findChild<QLabel*>(QStringLiteral("finding"))->text().toStdString(), answer.finding);
  EXPECT_EQ(
      answer.finding,
      "In simulated studies, the declared test (Welch’s t) finds a difference of d_z = 1: 12 "
      "participants 93\u00a0%, 14 participants 96\u00a0%. By a paired t-test, 14 participants in a "
      "cohort find a difference of d_z = 1 with a probability of 80\u00a0%; 12 find it with "
      "73\u00a0%.\n"
      "All participants have the same order: no number of them balances it.\n"
      "A session lasts about 16 minutes.");
  const auto caveats = dialog.findChild<NoteList*>(QStringLiteral("caveats"))->text();
  EXPECT_TRUE(caveats.contains(QStringLiteral("paired t-test"))) << caveats.toStdString();
  // As 'palpate plan' prints for 12 participants, where no method differs.
  EXPECT_TRUE(caveats.contains(QStringLiteral("in 15\u00a0% of simulated studies")))
      << caveats.toStdString();
  const auto& table = dialog.findChild<ResultView*>()->table();
  EXPECT_EQ(asCsv(table), asCsv(report::planTables(plan).front()));
  tests::photographInAllThemes(dialog, QStringLiteral("plan"));
}

TEST_F(StudyDialogsTest, ReportRefusesToOverwriteAFile) {
  out_.write("report.html", "mine");
  QString told;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, &look, [&] {
    auto* box = qobject_cast<MessageBox*>(QApplication::activeModalWidget());
    if (box == nullptr) return;
    told = box->words();
    box->accept();
  });
  look.start(20);
  ReportDialog dialog(summary());
  press(dialog, out_ / "report.html");
  EXPECT_TRUE(told.contains(QStringLiteral("is there already"))) << told.toStdString();
  EXPECT_EQ(tests::contentOf(out_ / "report.html"), "mine");
}

TEST_F(StudyDialogsTest, ExportOffersNoExactAgesWhereNoneIsAskedAndWarnsOfExactDates) {
  SystemClock clock;
  questionnaires::Problems problems;
  Study::create(
      out_ / "live", *protocols::loadProtocolFile("punch-face-validity", problems), clock, 7);
  ExportDialog dialog(summaryOf(out_ / "live"));
  dialog.show();
  auto* exact = dialog.findChild<QCheckBox*>(QStringLiteral("exact"));
  EXPECT_EQ(exact->text().remove(u'&'), QStringLiteral("Exact dates and times"));
  const auto warning = QStringLiteral("Exact dates point to people");
  EXPECT_FALSE(more(dialog).contains(warning));
  exact->setChecked(true);
  EXPECT_TRUE(more(dialog).contains(warning)) << more(dialog).toStdString();
}

TEST_F(StudyDialogsTest, EraseSaysFirstThatThereIsNobody) {
  EraseDialog dialog(summary());
  dialog.show();
  const auto* notice = dialog.findChild<QLabel*>(QStringLiteral("notice"));
  EXPECT_TRUE(notice->text().contains(QStringLiteral("nobody to erase"))) << "all are simulated";
  EXPECT_FALSE(dialog.findChild<QComboBox*>(QStringLiteral("participant"))->isVisible());
}

TEST_F(StudyDialogsTest, ExportNamesConditionsOnlyWhereAReasonIsGiven) {
  ExportDialog dialog(summary());
  auto* audience = dialog.findChild<QComboBox*>(QStringLiteral("audience"));
  auto* go = dialog.findChild<QPushButton*>(QStringLiteral("go"));
  audience->setCurrentIndex(1);
  EXPECT_FALSE(go->isEnabled());
  dialog.findChild<QLineEdit*>(QStringLiteral("reason"))->setText(QStringLiteral("plan signed"));
  EXPECT_TRUE(go->isEnabled());
  audience->setCurrentIndex(0);
  press(dialog, out_ / "data");
  // The published study says by its order which condition a code stands for.
  EXPECT_TRUE(
      outcome(dialog).contains(QStringLiteral("8 sessions, with codes for conditions but NOT")))
      << outcome(dialog).toStdString();
  EXPECT_EQ(tests::contentOf(out_ / "data/responses.csv").find("kalman"), std::string::npos);
  tests::photographInAllThemes(dialog, QStringLiteral("export"));
}

TEST_F(StudyDialogsTest, ExportShowsWhoIsIdentifiableBeforeWriting) {
  ExportDialog dialog(summary());
  dialog.show();
  dialog.findChild<QComboBox*>(QStringLiteral("audience"))->setCurrentIndex(2);
  SystemClock clock;
  std::string expected;
  {
    auto study = Study::open(this->study(), clock, storage::Database::Access::ReadOnly);
    expected = study::describe(
        publicRelease(study, {.runMode = RunMode::Simulated, .publicClassSize = 5}));
  }
  EXPECT_EQ(more(dialog).trimmed().toStdString() + "\n", expected);
  QTest::qWait(1);  // sizes follow what is shown
  const auto* smallest = dialog.findChild<QSpinBox*>(QStringLiteral("smallest-class"));
  EXPECT_TRUE(smallest->isVisible());
  EXPECT_GE(smallest->height(), smallest->minimumSizeHint().height());
  tests::photographInAllThemes(dialog, QStringLiteral("export-public"));
  press(dialog, out_ / "open");
  EXPECT_TRUE(outcome(dialog).contains(QStringLiteral("for the public")));
  dialog.findChild<QSpinBox*>(QStringLiteral("smallest-class"))->setValue(9);
  const auto* go = dialog.findChild<QPushButton*>(QStringLiteral("go"));
  EXPECT_FALSE(go->isEnabled());
  EXPECT_TRUE(outcome(dialog).startsWith(QStringLiteral("✕")));
  dialog.findChild<PathField*>()->setPath(QString::fromStdString(out_ / "other"));
  EXPECT_FALSE(go->isEnabled()) << "another folder does not make it possible";
}

TEST_F(StudyDialogsTest, ExportSaysWhatACodedFolderTellsOfPeopleBeforeWriting) {
  tests::MadeStudy made;
  auto session = Session::enrol(*made, {.cohort = "surgeons"});
  tests::walkToTheEnd(session);
  ExportDialog dialog(summaryOf(made.folder()));
  for (const int audience : {0, 1}) {
    dialog.findChild<QComboBox*>(QStringLiteral("audience"))->setCurrentIndex(audience);
    EXPECT_TRUE(
        more(dialog).contains(QStringLiteral("recognised by their cohort and background: 1 of 1.")))
        << more(dialog).toStdString();
    EXPECT_FALSE(more(dialog).contains(QStringLiteral("--"))) << "an option of the command line";
    EXPECT_FALSE(more(dialog).contains(u'`'));
  }
}

}  // namespace study_dialogs_test
}  // namespace study::gui
