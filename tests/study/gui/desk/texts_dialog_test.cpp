// The form for the blanks of a study's texts.
#include "study/gui/authoring/texts_dialog.h"

#include <algorithm>

#include <gtest/gtest.h>

#include <QApplication>
#include <QComboBox>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>
#include <QTimer>

#include "protocols/load_protocol.h"
#include "study/gui/home/home_window.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/studio_settings.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/made_study.h"

namespace study::gui {
namespace texts_dialog_test {

TEST(TextsDialogTest, AsksBeforeTypedTextsAreDiscarded) {
  questionnaires::Problems problems;
  TextsDialog form(*protocols::loadProtocolFile("punch-face-validity", problems));
  form.show();
  form.reject();
  EXPECT_FALSE(form.isVisible()) << "nothing was typed";
  form.show();
  form.findChild<QLineEdit*>(QStringLiteral("text-institution"))->setText(QStringLiteral("Lab"));
  const auto answer = [&](const char* button) {
    QTimer::singleShot(0, &form, [button] {
      QApplication::activeModalWidget()
          ->findChild<QPushButton*>(QString::fromUtf8(button))
          ->click();
    });
    QTest::keyClick(&form, Qt::Key_Escape);
  };
  answer("safe");
  EXPECT_TRUE(form.isVisible());
  answer("action");
  EXPECT_FALSE(form.isVisible());
}

TEST(TextsDialogTest, KeepsTheTextsOfALanguageWhenAnotherIsShown) {
  questionnaires::Problems problems;
  TextsDialog form(*protocols::loadProtocolFile("punch-face-validity", problems));
  const auto field = [&](const char* key) {
    return form.findChild<QLineEdit*>(QStringLiteral("text-") + QString::fromUtf8(key));
  };
  auto* languages = form.findChild<QComboBox*>(QStringLiteral("language"));
  const auto show = [&](const char* language) {
    languages->setCurrentIndex(languages->findData(QString::fromUtf8(language)));
  };
  const auto labels = form.findChildren<QLabel*>();
  EXPECT_TRUE(std::ranges::any_of(labels, [](const QLabel* label) {
    return label->text() == QStringLiteral("You may also ask us to delete your data, until ____.");
  }));
  const auto duration = field("duration")->text();
  ASSERT_FALSE(duration.isEmpty());
  QTest::keyClicks(field("data_kept_years"), QStringLiteral("10 years"));
  EXPECT_EQ(field("data_kept_years")->text(), QStringLiteral("10")) << "the texts name the unit";
  field("institution")->setText(QStringLiteral("Hospital"));
  field("contact")->setText(QStringLiteral("Eva"));
  show("de");
  EXPECT_EQ(field("institution")->text(), QString());
  field("institution")->setText(QStringLiteral("Klinik"));
  show("nb");
  show("en");
  EXPECT_EQ(field("institution")->text(), QStringLiteral("Hospital"));
  EXPECT_EQ(field("duration")->text(), duration);
  using Texts = std::map<std::string, std::string>;
  const auto texts = form.texts();
  EXPECT_EQ(texts.at("institution").all(), (Texts{{"en", "Hospital"}, {"de", "Klinik"}}));
  EXPECT_EQ(texts.at("contact").all(), (Texts{{"en", "Eva"}}));
  EXPECT_EQ(texts.at("duration").all(), (Texts{{"en", duration.toStdString()}}));
}

TEST(TextsDialogTest, AsksBeforeATextChangesWhatAnswersMean) {
  studioSettings().clear();
  auto instrument = tests::everythingInstrument();
  const std::string words = R"("text": {"en": "a",)";
  instrument.replace(instrument.find(words), words.size(), R"("text": {"en": "a [[contact]]",)");
  tests::MadeStudy study(
      tests::protocolFrom(tests::protocolWithEverything(), {{"everything.json", instrument}}));
  auto session = Session::enrol(*study, {.cohort = "surgeons", .runMode = RunMode::Pilot});
  const auto folder = study.folder();
  study.close();
  HomeWindow home;
  home.show();
  home.choose(QString::fromStdString(folder));
  std::string told;
  QTimer fill;
  QObject::connect(&fill, &QTimer::timeout, &fill, [&] {
    auto* window = QApplication::activeModalWidget();
    if (auto* form = qobject_cast<TextsDialog*>(window)) {
      form->findChild<QLineEdit*>(QStringLiteral("text-contact"))->setText(QStringLiteral("Eva"));
      form->accept();
    } else if (auto* question = qobject_cast<MessageBox*>(window)) {
      fill.stop();
      told = question->words().toStdString();
      question->accept();
    }
  });
  fill.start(20);
  QTest::mouseClick(home.findChild<QPushButton*>(QStringLiteral("texts")), Qt::LeftButton);
  EXPECT_NE(told.find("1 of 1 participants read other words"), std::string::npos) << told;
  study.reopen();
  EXPECT_EQ(study->protocols().all().size(), 2U) << "an amendment";
}

}  // namespace texts_dialog_test
}  // namespace study::gui
