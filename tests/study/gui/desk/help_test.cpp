#include <set>

#include <gtest/gtest.h>

#include <QApplication>
#include <QScrollBar>
#include <QTest>
#include <QTextBlock>

#include "haptics/devices/messages.h"
#include "protocols/load_protocol.h"
#include "study/gui/authoring/protocol_window.h"
#include "study/gui/desk/export_dialog.h"
#include "study/gui/desk/help_window.h"
#include "study/gui/desk/measurement_dialogs.h"
#include "study/gui/desk/new_study_dialog.h"
#include "study/gui/desk/self_test_dialog.h"
#include "study/gui/desk/study_dialogs.h"
#include "study/gui/desk/tour.h"
#include "study/gui/home/home_window.h"
#include "study/gui/operator/findings_dialog.h"
#include "study/gui/participant/trial_page.h"
#include "study/gui/widgets/message_box.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/known_secret.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace help_test {

class HelpTest : public testing::Test {
 protected:
  static void SetUpTestSuite() {
    installHelpKey(*qobject_cast<QApplication*>(QApplication::instance()));
  }
  void TearDown() override { delete openHelp(); }

  /// Presses F1 in a window and returns the heading of the help; empty if no help opens.
  static QString pressF1(QWidget& window) {
    delete openHelp();
    window.show();
    QTest::keyClick(&window, Qt::Key_F1);
    return openHelp() == nullptr ? QString() : openHelp()->heading();
  }
};

TEST_F(HelpTest, OpensAtTheSectionOfEachDeskWindow) {
  const StudySummary study{.folder = "/nowhere", .title = "A study"};
  HomeWindow home;
  NewStudyDialog make;
  ProtocolWindow protocol(QStringLiteral("punch-face-validity"));
  BackupDialog backup(study);
  VerifyDialog verify(study);
  ReportDialog report(study);
  ExportDialog exporting(study);
  SelfTestDialog test(SelfTestOptions{});
  Tour tour;
  ImportCutDialog import;
  const std::pair<QWidget*, const char*> expected[]{
      {&home, "The studio"},
      {&make, "Create the study"},
      {&protocol, "Write the protocol"},
      {&backup, "After each day"},
      {&verify, "After each day"},
      {&report, "The results"},
      {&exporting, "The results"},
      {&test, "System check"},
      {&tour, "Try it"},
      {&import, "Import a recording"}};
  for (const auto& [window, topic] : expected) {
    EXPECT_TRUE(pressF1(*window).contains(QString::fromUtf8(topic)))
        << window->metaObject()->className() << ": " << pressF1(*window).toStdString();
  }
}

TEST_F(HelpTest, OpensForTheOperatorButNotForTheParticipant) {
  const tests::ScratchFolder folder;
  SystemClock clock;
  questionnaires::Problems problems;
  auto study = Study::create(
      folder / "study",
      *protocols::loadProtocolFile("punch-face-validity", problems),
      clock,
      7,
      tests::knownSecret());
  OperatorWindow window(study);
  EXPECT_TRUE(pressF1(window).contains(QStringLiteral("The day")));
  const MessageBox box(MessageTopic::StepNotDone, {}, {}, &window);
  EXPECT_EQ(helpTopicOf(box), QStringLiteral("When something goes wrong"));
  window.enrol({.cohort = "professional", .language = "en", .code = {}});
  ASSERT_NE(window.participantWindow(), nullptr);
  EXPECT_EQ(pressF1(*window.participantWindow()), QString());
}

TEST_F(HelpTest, UsesTheTopicPropertyOfAWidget) {
  HomeWindow home;
  QWidget part(&home);
  part.setProperty("help", QStringLiteral("Copies"));
  EXPECT_EQ(helpTopicOf(part), QStringLiteral("Copies"));
}

TEST_F(HelpTest, OpensThePageOnDevicesFromWhatACheckFound) {
  using haptics::devices::deviceMessage;
  using haptics::devices::Finding;
  const auto helpOn = [](const haptics::devices::CheckResult& result) {
    delete openHelp();
    FindingsDialog dialog({{"punch", {result}}}, FindingsDialog::Question::Nothing, {}, nullptr);
    dialog.QDialog::show();
    dialog.findChild<QPushButton*>(QStringLiteral("help"))->click();
    return openHelp() == nullptr ? QString() : openHelp()->heading();
  };
  EXPECT_EQ(
      helpOn(
          {Finding::Warn,
           deviceMessage("check.round_trip"),
           deviceMessage("check.median_and_p99", 1210.0, 4100.0),
           deviceMessage("check.round_trip.fix")}),
      QStringLiteral("Real time"));
  EXPECT_EQ(
      helpOn(
          {Finding::Fail,
           deviceMessage("check.board_faults"),
           deviceMessage("check.board_faults.encoder"),
           deviceMessage("check.board_faults.fix")}),
      QStringLiteral("Trouble"));
}

TEST_F(HelpTest, FitsPicturesAndLinesIntoTheWindow) {
  HelpWindow help;
  help.resize(1100, 760);  // the screen of tests is smaller
  help.showTopic({});
  auto* text = help.findChild<QTextBrowser*>();
  std::set<double> widths;
  QCoreApplication::processEvents();
  for (auto block = text->document()->begin(); block.isValid(); block = block.next()) {
    for (auto part = block.begin(); !part.atEnd(); ++part) {
      const auto image = part.fragment().charFormat().toImageFormat();
      if (!image.isValid()) continue;
      EXPECT_GT(image.width(), 400.0) << "the initial width";
    }
  }
  for (const int wide : {760, 1400}) {
    help.resize(wide, 700);
    QCoreApplication::processEvents();
    EXPECT_EQ(text->horizontalScrollBar()->maximum(), 0) << wide;
    for (auto block = text->document()->begin(); block.isValid(); block = block.next()) {
      for (auto part = block.begin(); !part.atEnd(); ++part) {
        const auto image = part.fragment().charFormat().toImageFormat();
        if (!image.isValid()) continue;
        EXPECT_LE(image.width(), text->viewport()->width());
        widths.insert(image.width());
      }
    }
  }
  EXPECT_GT(widths.size(), 2U) << "a wide window has room for the whole picture";
}

TEST_F(HelpTest, ShowsPicturesAndOtherPages) {
  HelpWindow help;
  help.showTopic({});
  EXPECT_EQ(help.heading(), QStringLiteral("Running a study"));
  auto* text = help.findChild<QTextBrowser*>();
  int pictures = 0;
  for (auto block = text->document()->begin(); block.isValid(); block = block.next()) {
    for (auto part = block.begin(); !part.atEnd(); ++part) {
      const auto image = part.fragment().charFormat().toImageFormat();
      if (!image.isValid()) continue;
      ++pictures;
      EXPECT_FALSE(text->loadResource(QTextDocument::ImageResource, QUrl(image.name())).isNull())
          << image.name().toStdString();
    }
  }
  EXPECT_GE(pictures, 3);
  text->setSource(QUrl(QStringLiteral("qrc:/help/protocol-format.md")));
  EXPECT_GT(text->document()->blockCount(), 50);
  help.showTopic(QStringLiteral("The day"));
  EXPECT_TRUE(help.heading().contains(QStringLiteral("The day")));
  tests::photographInAllThemes(help, QStringLiteral("help"));
}

}  // namespace help_test
}  // namespace study::gui
