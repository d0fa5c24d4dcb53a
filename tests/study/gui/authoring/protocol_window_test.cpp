#include "study/gui/authoring/protocol_window.h"

#include <filesystem>
#include <fstream>

#include <gtest/gtest.h>

#include <QApplication>
#include <QDialogButtonBox>
#include <QFileDialog>
#include <QPlainTextEdit>
#include <QPushButton>
#include <QScreen>
#include <QScrollArea>
#include <QScrollBar>
#include <QTest>
#include <QTextBlock>
#include <QTimer>
#include <QTreeWidget>

#include "protocols/load_protocol.h"
#include "study/gui/authoring/timeline_bar.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/result_table.h"
#include "study/gui/widgets/studio_settings.h"
#include "study/session/session_length.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/made_study.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace protocol_window_test {

std::string shipped(std::string_view name) {
  for (const auto& file : protocols::libraryFiles()) {
    if (file.name == name) return std::string(file.content);
  }
  return {};
}

std::string replaced(std::string text, const std::string& what, const std::string& with) {
  const auto place = text.find(what);
  EXPECT_NE(place, std::string::npos) << what;
  return place == std::string::npos ? text : text.replace(place, what.size(), with);
}

class ProtocolWindowTest : public testing::Test {
 protected:
  QString write(const std::string& text) {
    return QString::fromStdString(folder_.write("mine.json", text));
  }

  static QTableWidget* problemsOf(ProtocolWindow& window) {
    for (auto* table : window.findChildren<QTableWidget*>()) {
      if (table->accessibleName() == QStringLiteral("Problems")) return table;
    }
    return nullptr;
  }

  tests::ScratchFolder folder_;
  std::string sound_ = shipped("punch-face-validity.json");
};

TEST_F(ProtocolWindowTest, OpensNoLargerThanTheScreen) {
  ProtocolWindow window(QStringLiteral("punch-face-validity"));
  const QSize screen = window.screen()->availableSize();
  ASSERT_LT(screen.height(), 820) << "the height that it would like";
  EXPECT_LT(window.height(), screen.height());
  EXPECT_LT(window.width(), screen.width());
}

TEST_F(ProtocolWindowTest, ShowsTheMinutesOfThePlan) {
  ProtocolWindow window(QStringLiteral("punch-face-validity"));
  window.show();
  ASSERT_TRUE(window.checked().loaded);
  const auto& loaded = *window.checked().loaded;
  auto* steps = window.findChild<QTreeWidget*>();
  ASSERT_EQ(steps->topLevelItemCount(), static_cast<int>(loaded.protocol.phases.size()));
  double minutes = 0.0;
  for (int i = 0; i < steps->topLevelItemCount(); ++i) {
    minutes += steps->topLevelItem(i)->text(2).toDouble();
  }
  EXPECT_NEAR(minutes, lengthOf(loaded, {}).seconds / 60.0, 0.05 * steps->topLevelItemCount());
  tests::photographInAllThemes(window, QStringLiteral("protocol"));
}

TEST_F(ProtocolWindowTest, FillsOfTheBarWhatTheSentenceNamesAsTimeOnTheDevice) {
  ProtocolWindow window(QStringLiteral("punch-face-validity"));
  const auto& loaded = *window.checked().loaded;
  const auto length = lengthOf(loaded, {});
  double seconds = 0.0;
  double felt = 0.0;
  for (const auto& part : window.findChild<TimelineBar*>()->parts()) {
    seconds += part.seconds();
    for (const auto& stretch : part.periods) felt += stretch.isOnDevice ? stretch.seconds : 0.0;
  }
  EXPECT_NEAR(seconds, length.seconds, 1e-6);
  EXPECT_NEAR(felt, length.secondsOnDevice, 1e-6);
  EXPECT_GT(felt, 0.0);
  EXPECT_TRUE(
      window.findChild<QTreeWidget*>()->topLevelItem(1)->text(0).startsWith(QStringLiteral("2 ")))
      << "the number by which the bar names a short phase";
}

TEST_F(ProtocolWindowTest, ShowsTheOrderOfEachParticipant) {
  ProtocolWindow window(QStringLiteral("punch-counterbalanced"));
  window.show();
  window.findChild<QTabWidget*>()->setCurrentIndex(2);
  const auto& protocol = window.checked().loaded->protocol;
  QTableWidget* orders = nullptr;
  for (auto* table : window.findChildren<QTableWidget*>()) {
    if (table->accessibleName() == QStringLiteral("Orders")) orders = table;
  }
  ASSERT_NE(orders, nullptr);
  const auto trials =
      protocols::scheduleFor(protocol, protocol.seed.value_or(1), protocol.cohorts.front().id, 2)
          .blocks.front()
          .trials;
  const QStringList shown = orders->item(2, 2)->text().split(QStringLiteral(" · "));
  ASSERT_EQ(shown.size(), static_cast<int>(trials.size()));
  for (int i = 0; i < shown.size(); ++i) {
    const auto& trial = trials[static_cast<std::size_t>(i)];
    EXPECT_EQ(
        shown[i].toStdString(),
        std::to_string(trial.label) + " " + protocol.condition(trial.condition)->title);
  }
  const auto* balance = window.findChild<ResultTable*>();
  EXPECT_TRUE(balance->item(0, 1)->text().startsWith(QStringLiteral("Felt  ·  Balance: balanced")))
      << balance->item(0, 1)->text().toStdString();
  EXPECT_EQ(balance->item(1, 3)->text(), QStringLiteral("4 · 4 · 4"));
  tests::photographInAllThemes(window, QStringLiteral("orders"));
}

TEST_F(ProtocolWindowTest, GoesToTheLineOfAClickedProblem) {
  const auto broken = replaced(sound_, "\"planned\": 6", "\"planned\": \"six\"");
  ProtocolWindow window(write(broken));
  window.show();
  EXPECT_FALSE(window.checked().loaded);
  auto* problems = problemsOf(window);
  ASSERT_GE(problems->rowCount(), 1);
  EXPECT_TRUE(problems->isVisible()) << "an error is seen first";
  problems->setCurrentCell(0, 2);
  ASSERT_GE(window.markedLine(), 0);
  const auto* text = window.findChild<QPlainTextEdit*>();
  EXPECT_EQ(text->textCursor().blockNumber(), window.markedLine());
  EXPECT_TRUE(text->textCursor().block().text().contains(QStringLiteral("\"six\"")))
      << text->textCursor().block().text().toStdString();
  EXPECT_EQ(text->extraSelections().size(), 1);
  tests::photographInAllThemes(window, QStringLiteral("protocol-broken"));
}

TEST_F(ProtocolWindowTest, CountsNoBlanksThatWereFilledInBefore) {
  ProtocolWindow window(QStringLiteral("punch-counterbalanced"));
  EXPECT_EQ(window.checked().warnings(), 1) << "blanks";
  window.keepTextsOf(tests::filledIn(*window.checked().loaded));
  EXPECT_EQ(window.checked().warnings(), 0);
}

TEST_F(ProtocolWindowTest, ShowsASummaryFirstAndTheSourceOnRequest) {
  ProtocolWindow window(QStringLiteral("punch-face-validity"));
  window.show();
  const auto words = window.findChild<QLabel*>(QStringLiteral("summary"))->text();
  for (const auto* part :
       {"Orthopaedic surgeons: 6 planned",
        "Interpolation",
        "Round 1",
        "3 comparisons by Welch's t-test",
        "9 questions; 3 about each condition, not all the same"}) {
    EXPECT_TRUE(words.contains(QLatin1String(part))) << part << " in " << words.toStdString();
  }
  auto* text = window.findChild<QPlainTextEdit*>();
  EXPECT_FALSE(text->isVisible());
  window.findChild<QPushButton*>(QStringLiteral("show-source"))->click();
  EXPECT_TRUE(text->isVisible());
}

TEST_F(ProtocolWindowTest, SaysThatThePublishedDesignKeepsItsWeaknesses) {
  const auto saidOf = [](const char* name) {
    ProtocolWindow window(QString::fromUtf8(name));
    return window.findChild<QLabel*>(QStringLiteral("about-problems"))->text();
  };
  const auto known = QStringLiteral("kept as published");
  EXPECT_TRUE(saidOf("punch-face-validity").contains(known));
  EXPECT_FALSE(saidOf("punch-counterbalanced").contains(known)) << "only blanks are left";
}

TEST_F(ProtocolWindowTest, NamesPlacesWithoutSignsOfTheFileFormat) {
  const CheckedProtocol broken;
  EXPECT_EQ(
      broken.placeInWords("consent-punch $.phases[4].data_kept"),
      QStringLiteral("consent-punch › phases 5 › data kept"));
  ProtocolWindow window(QStringLiteral("punch-face-validity"));
  auto* problems = problemsOf(window);
  ASSERT_GE(problems->rowCount(), 1);
  EXPECT_EQ(problems->item(0, 2)->text(), QStringLiteral("10 blanks in texts for participants"));
  for (int row = 0; row < problems->rowCount(); ++row) {
    EXPECT_FALSE(problems->item(row, 1)->text().contains(u'$'));
    EXPECT_TRUE(problems->item(row, 1)->toolTip().contains(u'$')) << "for the author of a file";
  }
}

TEST_F(ProtocolWindowTest, NamesPartsOfAProtocolByTheirTitles) {
  const auto checked = checkProtocol("punch-face-validity");
  EXPECT_EQ(
      checked.placeInWords("$.phases[6].questionnaires[0]"),
      QStringLiteral("phase 7, Round 2 › questionnaires 1"));
  EXPECT_EQ(
      checked.placeInWords("$.analysis.families[0].test"),
      QStringLiteral("comparisons 1, Realism of the three methods › test"));
  EXPECT_EQ(
      checked.placeInWords("consent-punch-2 $.introduction"),
      QStringLiteral("Consent › introduction"));
  QString words;
  for (const auto& note : checked.notes()) words += note.text;
  EXPECT_TRUE(words.contains(QStringLiteral("'KF'"))) << words.toStdString();
  EXPECT_FALSE(words.contains(QStringLiteral("'kalman'"))) << words.toStdString();
}

TEST_F(ProtocolWindowTest, ListsErrorsBeforeWarnings) {
  using questionnaires::Severity;
  const auto problem = [](Severity severity, const char* what) {
    return questionnaires::Problem{
        .severity = severity, .path = "$", .what = base::Message::verbatim(what)};
  };
  const auto broken = checkedProtocol(
      "mine.json",
      "",
      std::nullopt,
      {problem(Severity::Warning, "weak"), problem(Severity::Error, "wrong")});
  ASSERT_EQ(broken.notes().size(), 2U);
  EXPECT_EQ(broken.notes().front().text, QStringLiteral("Wrong"));
  EXPECT_EQ(broken.notes().front().mark, Mark::Bad);
}

TEST_F(ProtocolWindowTest, ReloadsAChangedFile) {
  const QString file = write(replaced(sound_, "\"phases\"", "\"phasen\""));
  ProtocolWindow window(file);
  ASSERT_FALSE(window.checked().loaded);
  write(sound_);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.checked().loaded.has_value(); }));
  EXPECT_EQ(window.findChild<QPlainTextEdit*>()->toPlainText().toStdString(), sound_);
  EXPECT_GT(window.findChild<QTreeWidget*>()->topLevelItemCount(), 0);
}

TEST_F(ProtocolWindowTest, ReloadsAFileThatAnEditorReplacesRepeatedly) {
  const QString file = write(sound_);
  ProtocolWindow window(file);
  ASSERT_TRUE(window.checked().loaded);
  const auto replace = [&](const std::string& text) {
    std::filesystem::rename(folder_.write("mine.json~", text), file.toStdString());
  };
  replace(replaced(sound_, "\"phases\"", "\"phasen\""));
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.checked().loaded.has_value(); }));
  replace(sound_);
  ASSERT_TRUE(QTest::qWaitFor([&] { return window.checked().loaded.has_value(); }));
}

TEST_F(ProtocolWindowTest, SavesAShippedProtocolAsOneOfOnesOwn) {
  studioSettings().clear();
  ProtocolWindow window(QStringLiteral("punch-counterbalanced"));
  window.resize(1240, 820);  // the screen of tests is smaller
  window.show();
  QCoreApplication::processEvents();
  const auto* outer = qobject_cast<QScrollArea*>(window.centralWidget());
  EXPECT_EQ(outer->verticalScrollBar()->maximum(), 0) << "each part scrolls by itself";
  tests::photographInAllThemes(window, QStringLiteral("protocol-shipped"));
  const auto file = QString::fromStdString(folder_ / "our-punch.json");
  QTimer answer;
  QObject::connect(&answer, &QTimer::timeout, &answer, [&] {
    auto* asked = QApplication::activeModalWidget();
    if (auto* title = qobject_cast<MessageBox*>(asked)) {
      title->setText(QStringLiteral("Our punch"));
      title->accept();
    } else if (auto* where = qobject_cast<QFileDialog*>(asked)) {
      answer.stop();
      EXPECT_TRUE(where->selectedFiles().front().endsWith(QStringLiteral("/our-punch.json")));
      where->selectFile(file);
      where->findChild<QDialogButtonBox*>()->button(QDialogButtonBox::Save)->click();
    }
  });
  answer.start(20);
  auto* save = window.findChild<QPushButton*>(QStringLiteral("save-as"));
  QTest::mouseClick(save, Qt::LeftButton);
  ASSERT_TRUE(window.checked().loaded) << window.checked().verdict();
  EXPECT_EQ(window.checked().source, file.toStdString()) << "the window shows the new file";
  EXPECT_EQ(window.checked().loaded->protocol.study.id, "our-punch");
  EXPECT_EQ(window.checked().loaded->protocol.study.title, "Our punch");
  EXPECT_FALSE(save->isVisible()) << "it is a file already";
  EXPECT_EQ(protocolFolder(), QFileInfo(file).absolutePath());
}

TEST_F(ProtocolWindowTest, ReportsAMissingFile) {
  const QString file = write(sound_);
  ProtocolWindow window(file);
  std::filesystem::remove(file.toStdString());
  ASSERT_TRUE(QTest::qWaitFor([&] { return !window.checked().loaded.has_value(); }));
  ASSERT_EQ(window.checked().problems.size(), 1U);
  EXPECT_NE(base::describe(window.checked().problems[0].what).find("mine.json"), std::string::npos);
}

}  // namespace protocol_window_test
}  // namespace study::gui
