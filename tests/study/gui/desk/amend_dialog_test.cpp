#include <gtest/gtest.h>

#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "protocols/load_protocol.h"
#include "study/cohort/simulated_participant.h"
#include "study/gui/desk/task_dialogs.h"
#include "study/model/clock.h"
#include "tests/study/gui/pictures.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace amend_dialog_test {

class AmendDialogTest : public testing::Test {
 protected:
  /// Enters the changed protocol and presses the button.
  static void press(QDialog& dialog, const std::string& changed) {
    dialog.show();
    dialog.findChild<PathField*>()->setPath(QString::fromStdString(changed));
    QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("go")), Qt::LeftButton);
  }
  static QString outcome(QDialog& dialog) {
    return dialog.findChild<QLabel*>(QStringLiteral("outcome"))->text();
  }
  static QString more(QDialog& dialog) {
    return dialog.findChild<NoteList*>(QStringLiteral("more"))->text();
  }

  /// @p protocol under another title.
  static std::string retitled(const protocols::LoadedProtocol& protocol) {
    auto text = protocol.text;
    const std::string title = "\"title\": \"";
    return text.insert(text.find(title) + title.size(), "Changed: ");
  }

  tests::ScratchFolder out_;
};

TEST_F(AmendDialogTest, ChangesTheProtocolOfNewSessions) {
  questionnaires::Problems problems;
  const auto protocol = *protocols::loadProtocolFile("two-devices", problems);
  SystemClock clock;
  Study::create(out_ / "other", protocol, clock, 7);
  const auto text = retitled(protocol);
  const auto file = out_.write("changed.json", text);
  AmendDialog dialog(summaryOf(out_ / "other"));
  auto* go = dialog.findChild<QPushButton*>(QStringLiteral("go"));
  dialog.findChild<PathField*>()->setPath(QString::fromStdString(file));
  EXPECT_FALSE(go->isEnabled()) << "without a reason";
  dialog.findChild<QLineEdit*>(QStringLiteral("reason"))->setText(QStringLiteral("a new title"));
  press(dialog, file);
  EXPECT_TRUE(outcome(dialog).startsWith(QStringLiteral("✓"))) << outcome(dialog).toStdString();
  auto study = Study::open(out_ / "other", clock, storage::Database::Access::ReadOnly);
  EXPECT_EQ(study.protocol().text, text);
  tests::photographInAllThemes(dialog, QStringLiteral("amend"));
}

TEST_F(AmendDialogTest, SaysBeforehandWhatItChangesInWhatWasFelt) {
  questionnaires::Problems problems;
  const auto protocol = *protocols::loadProtocolFile("two-devices", problems);
  {
    SimulatedClock clock;
    auto study = Study::create(out_ / "other", protocol, clock, 7);
    auto session = Session::enrol(
        study,
        {.cohort = protocol.protocol.cohorts.front().id, .runMode = RunMode::Pilot, .code = {}});
    simulateUntil(study, session, clock, 1, static_cast<int>(session.plan().size()));
  }
  auto text = protocol.text;
  const auto& title = protocol.protocol.conditions.front().title;
  text.replace(text.find("\"" + title + "\""), title.size() + 2, "\"Another title\"");
  AmendDialog dialog(summaryOf(out_ / "other"));
  dialog.findChild<PathField*>()->setPath(QString::fromStdString(out_.write("changed.json", text)));
  EXPECT_TRUE(more(dialog).contains(QStringLiteral("1 of 1 participants felt this under another")))
      << more(dialog).toStdString();
}

TEST_F(AmendDialogTest, KeepsTheTextsOfTheStudy) {
  questionnaires::Problems problems;
  const auto shipped = *protocols::loadProtocolFile("punch-face-validity", problems);
  questionnaires::BlankTexts texts;
  for (const auto& blank : protocols::blanksOf(shipped)) {
    texts[blank.key] = questionnaires::LocalizedText({{"en", "our words"}, {"de", "eigenes"}});
  }
  const auto filled = *protocols::withTexts(shipped, texts, problems);
  SystemClock clock;
  Study::create(out_ / "other", filled, clock, 7);
  const auto text = retitled(shipped);
  const auto file = out_.write("changed.json", text);
  AmendDialog dialog(summaryOf(out_ / "other"));
  dialog.findChild<QLineEdit*>(QStringLiteral("reason"))->setText(QStringLiteral("a new title"));
  press(dialog, file);
  EXPECT_TRUE(outcome(dialog).startsWith(QStringLiteral("✓"))) << outcome(dialog).toStdString();
  auto study = Study::open(out_ / "other", clock, storage::Database::Access::ReadOnly);
  EXPECT_TRUE(study.protocol().protocol.study.title.starts_with("Changed: "));
  EXPECT_EQ(study.protocol().protocol.texts, texts);
  EXPECT_EQ(summaryOf(out_ / "other").blanks, 0U);
}

TEST_F(AmendDialogTest, ReadsItsFileAgainWhenItChanges) {
  questionnaires::Problems problems;
  const auto protocol = *protocols::loadProtocolFile("two-devices", problems);
  SystemClock clock;
  Study::create(out_ / "other", protocol, clock, 7);
  const auto file = out_.write("same.json", protocol.text);
  AmendDialog dialog(summaryOf(out_ / "other"));
  auto* go = dialog.findChild<QPushButton*>(QStringLiteral("go"));
  auto* reason = dialog.findChild<QLineEdit*>(QStringLiteral("reason"));
  reason->setText(QStringLiteral("a new title"));
  press(dialog, file);
  EXPECT_TRUE(outcome(dialog).contains(QStringLiteral("uses already")));
  reason->setText(QStringLiteral("another reason"));
  EXPECT_FALSE(go->isEnabled()) << "the file is the same as before";
  out_.write("same.json", "{");
  QTRY_VERIFY(outcome(dialog).contains(QStringLiteral("Not valid yet")));
  auto text = protocol.text;
  const std::string title = "\"title\": \"";
  text.insert(text.find(title) + title.size(), "Changed: ");
  out_.write("same.json", text);
  QTRY_VERIFY(outcome(dialog).contains(QStringLiteral("Valid")));
  EXPECT_TRUE(go->isEnabled());
}

}  // namespace amend_dialog_test
}  // namespace study::gui
