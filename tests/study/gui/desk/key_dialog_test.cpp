#include "study/gui/desk/key_dialog.h"

#include <filesystem>

#include <gtest/gtest.h>

#include <QLabel>
#include <QPushButton>
#include <QTest>

#include "study/gui/home/study_panel.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/written_file.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/made_study.h"

namespace study::gui {
namespace key_dialog_test {

class KeyDialogTest : public testing::Test {
 protected:
  KeyDialogTest() { study_.close(); }

  template <typename Widget>
  static Widget& the(QDialog& dialog, const char* name) {
    return *dialog.findChild<Widget*>(QString::fromUtf8(name));
  }

  static void setPaths(QDialog& dialog, const std::string& path) {
    for (auto* field : dialog.findChildren<PathField*>()) {
      field->setPath(QString::fromStdString(path));
    }
  }

  StudySummary summary() { return summaryOf(study_.folder()); }

  tests::MadeStudy study_;
  std::string file_ = study_.scratch() / "key.txt";
};

TEST_F(KeyDialogTest, SaysTheStateOfTheKeyInTheLanguageOfTheDesk) {
  setDeskLanguage("de");
  const KeyDialog dialog(summary());
  const auto notice = dialog.findChild<QLabel*>(QStringLiteral("notice"))->text();
  setDeskLanguage("en");
  EXPECT_TRUE(notice.contains(QStringLiteral("versiegelt"))) << notice.toStdString();
}

TEST_F(KeyDialogTest, SavesTheKeyWithAReason) {
  EXPECT_TRUE(summary().lacksKeyBackup);
  StudyPanel panel;
  const auto* remark = panel.findChild<QLabel*>(QStringLiteral("key-remark"));
  panel.show(summary());
  EXPECT_FALSE(remark->parentWidget()->isHidden())
      << "what is lost without a copy, and how to make one";
  KeyDialog dialog(summary());
  EXPECT_TRUE(the<QLabel>(dialog, "notice")
                  .text()
                  .contains(QStringLiteral("only this account has the key")));
  auto& go = the<QPushButton>(dialog, "go");
  EXPECT_FALSE(go.isEnabled()) << "without a reason";
  the<QLineEdit>(dialog, "reason").setText(QStringLiteral("a copy"));
  setPaths(dialog, file_);
  tests::photographInAllThemes(dialog, QStringLiteral("key"));
  go.click();
  EXPECT_TRUE(std::filesystem::exists(file_));
  EXPECT_FALSE(summary().lacksKeyBackup);
  panel.show(summary());
  EXPECT_TRUE(remark->parentWidget()->isHidden());
  EXPECT_EQ(dialog.findChild<WrittenFile*>()->path().toStdString(), file_);
}

TEST_F(KeyDialogTest, TakesItOnAnotherComputer) {
  {
    KeyDialog dialog(summary());
    the<QLineEdit>(dialog, "reason").setText(QStringLiteral("a second room"));
    setPaths(dialog, file_);
    the<QPushButton>(dialog, "go").click();
  }
  const tests::OwnStation elsewhere(study_.scratch() / "elsewhere");
  KeyDialog dialog(summary());
  EXPECT_TRUE(
      the<QLabel>(dialog, "notice").text().contains(QStringLiteral("does not have the key")));
  EXPECT_EQ(the<QComboBox>(dialog, "wanted").currentIndex(), 1) << "this is what is wanted here";
  setPaths(dialog, file_);
  the<QPushButton>(dialog, "go").click();
  EXPECT_FALSE(
      the<QLabel>(dialog, "notice").text().contains(QStringLiteral("does not have the key")));
  study_.reopen();
  EXPECT_TRUE(study_->hasKey());
}

TEST_F(KeyDialogTest, PutsNamesBehindAPassphrase) {
  KeyDialog dialog(summary());
  the<QComboBox>(dialog, "wanted").setCurrentIndex(2);
  auto& go = the<QPushButton>(dialog, "go");
  the<QLineEdit>(dialog, "reason").setText(QStringLiteral("the ethics committee asks for it"));
  the<QLineEdit>(dialog, "passphrase").setText(QStringLiteral("twelve grey horses"));
  the<QLineEdit>(dialog, "again").setText(QStringLiteral("twelve gray horses"));
  EXPECT_FALSE(go.isEnabled()) << "typed twice, and not the same";
  the<QLineEdit>(dialog, "again").setText(QStringLiteral("twelve grey horses"));
  go.click();
  storage::clearCachedKeys();
  study_.reopen();
  EXPECT_TRUE(study_->identities().isLocked());
  EXPECT_TRUE(study_->unlockNames("twelve grey horses"));
}

}  // namespace key_dialog_test
}  // namespace study::gui
