#include "study/gui/desk/erase_dialog.h"

#include <filesystem>

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "tests/study/everything_instrument.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/made_study.h"
#include "tests/study/walk.h"

namespace study::gui {
namespace erase_dialog_test {

const std::string kName = "Zaphod Beeblebrox";

/// A study with two participants; the first one gave a name.
class EraseDialogTest : public testing::Test {
 protected:
  EraseDialogTest() {
    for (const auto mode : {RunMode::Live, RunMode::Live, RunMode::Simulated}) {
      auto session = Session::enrol(*study_, {.cohort = "surgeons", .runMode = mode});
      tests::walkTo(session, StepKind::Form);
      if (session.participant() == "P001") {
        session.record({.item = "name", .response = kName, .itemOrder = 10});
      }
    }
    study_.close();
  }

  template <typename Widget>
  static Widget& the(QDialog& dialog, const char* name) {
    return *dialog.findChild<Widget*>(QString::fromUtf8(name));
  }
  static QPushButton& button(QDialog& dialog) { return the<QPushButton>(dialog, "go"); }

  static void fillIn(EraseDialog& dialog, const QString& code, const QString& certificate) {
    auto& people = the<QComboBox>(dialog, "participant");
    people.setCurrentIndex(people.findData(code));
    the<QLineEdit>(dialog, "reason").setText(QStringLiteral("asked for it"));
    for (auto* field : dialog.findChildren<PathField*>()) {
      if (!field->path().isEmpty()) field->setPath(certificate);
    }
  }

  SessionState stateOf(std::int64_t session) {
    study_.reopen();
    const auto state = study_->sessions().load(SessionId{session}).state;
    study_.close();
    return state;
  }

  tests::MadeStudy study_{tests::protocolFrom(
      tests::protocolWithEverything(), {{"everything.json", tests::everythingInstrument()}})};
};

TEST_F(EraseDialogTest, ListsPeopleWithNameCohortDateAndStateAndNobodySimulated) {
  study_.reopen();
  constexpr int kDate = 10;  // letters
  const auto date = localTime(study_->sessions().all().front().startedUtc).left(kDate);
  study_.close();
  EraseDialog dialog(summaryOf(study_.folder()));
  const auto& people = the<QComboBox>(dialog, "participant");
  ASSERT_EQ(people.count(), 2);
  EXPECT_EQ(people.itemText(0), QStringLiteral("P001 · Zaphod Beeblebrox · ") + date);
  EXPECT_EQ(people.itemText(1), QStringLiteral("P002 · ") + date);
  EXPECT_EQ(
      the<QLabel>(dialog, "sessions").text(),
      QStringLiteral("Surgeons, %1, in progress").arg(date));
  EXPECT_FALSE(the<QCheckBox>(dialog, "reseal").isVisibleTo(&dialog));
}

TEST_F(EraseDialogTest, ErasesOnlyAfterTheCodeWasTyped) {
  EraseDialog dialog(summaryOf(study_.folder()));
  const std::string file = study_.scratch() / "certificate.pdf";
  fillIn(dialog, QStringLiteral("P001"), QString::fromStdString(file));
  dialog.show();
  EXPECT_FALSE(button(dialog).isEnabled());
  auto& code = the<QLineEdit>(dialog, "code");
  code.setText(QStringLiteral("P002"));
  EXPECT_FALSE(button(dialog).isEnabled());
  code.setText(QStringLiteral("P001"));
  EXPECT_TRUE(button(dialog).isEnabled());
  tests::photographInAllThemes(dialog, QStringLiteral("erase"));
  QTest::mouseClick(&button(dialog), Qt::LeftButton);
  const auto outcome = the<QLabel>(dialog, "outcome").text();
  EXPECT_TRUE(outcome.startsWith(QStringLiteral("✓"))) << outcome.toStdString();
  EXPECT_TRUE(the<NoteList>(dialog, "more").text().contains(QStringLiteral("P001")));
  EXPECT_EQ(tests::contentOf(file).substr(0, 5), "%PDF-");
  EXPECT_EQ(the<QComboBox>(dialog, "participant").count(), 1);
  EXPECT_TRUE(code.text().isEmpty());
  EXPECT_EQ(stateOf(1), SessionState::Erased);
  EXPECT_NE(stateOf(2), SessionState::Erased);
}

TEST_F(EraseDialogTest, ErasesNothingIfTheCertificateCannotBeSaved) {
  EraseDialog dialog(summaryOf(study_.folder()));
  const auto file = study_.scratch().write("certificate.pdf", "another one");
  fillIn(dialog, QStringLiteral("P001"), QString::fromStdString(file));
  the<QLineEdit>(dialog, "code").setText(QStringLiteral("P001"));
  dialog.show();
  QTest::mouseClick(&button(dialog), Qt::LeftButton);
  const auto outcome = the<QLabel>(dialog, "outcome").text();
  EXPECT_EQ(outcome, QStringLiteral("✕  Nothing was erased: the certificate cannot be saved."));
  EXPECT_EQ(tests::contentOf(file), "another one");
  EXPECT_NE(stateOf(1), SessionState::Erased);
}

TEST_F(EraseDialogTest, SaysWhatWasErasedAlsoIfTheCertificateWasNotSaved) {
  EraseDialog dialog(summaryOf(study_.folder()));
  const std::string tooLong(300, 'x');  // for a name of a file, which only writing it shows
  const std::string file = study_.scratch() / (tooLong + ".pdf");
  fillIn(dialog, QStringLiteral("P001"), QString::fromStdString(file));
  the<QLineEdit>(dialog, "code").setText(QStringLiteral("P001"));
  dialog.show();
  QTest::mouseClick(&button(dialog), Qt::LeftButton);
  const auto outcome = the<QLabel>(dialog, "outcome").text();
  EXPECT_EQ(outcome, QStringLiteral("!  P001 is erased, but the certificate was not saved."));
  const auto more = the<NoteList>(dialog, "more").text();
  EXPECT_TRUE(more.contains(QStringLiteral("Could not write"))) << more.toStdString();
  EXPECT_TRUE(more.contains(QStringLiteral("P001"))) << "the certificate's text";
  EXPECT_EQ(the<QComboBox>(dialog, "participant").count(), 1);
  EXPECT_EQ(stateOf(1), SessionState::Erased);
}

TEST_F(EraseDialogTest, NeedsAReason) {
  EraseDialog dialog(summaryOf(study_.folder()));
  fillIn(dialog, QStringLiteral("P002"), {});
  the<QLineEdit>(dialog, "code").setText(QStringLiteral("P002"));
  EXPECT_TRUE(button(dialog).isEnabled());
  the<QLineEdit>(dialog, "reason").clear();
  EXPECT_FALSE(button(dialog).isEnabled());
}

}  // namespace erase_dialog_test
}  // namespace study::gui
