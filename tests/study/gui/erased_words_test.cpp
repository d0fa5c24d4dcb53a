// What is typed into the windows during sessions is gone after an erasure.
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <QApplication>
#include <QLineEdit>
#include <QTest>
#include <QTimer>

#include "study/gui/operator/control_panel.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/studio_settings.h"
#include "study/session/erasure.h"
#include "study/storage/records.h"
#include "tests/study/everything_instrument.h"
#include "tests/study/gui/participant.h"
#include "tests/study/made_study.h"
#include "tests/study/session/erased_study.h"

namespace study::gui {
namespace erased_words_test {

namespace fs = std::filesystem;
using tests::buttonSaying;
using Texts = std::vector<std::string>;

/// In every text that is typed. It has no space: words at the end of a line stay together.
const QString kSentinel = QStringLiteral("Sentinel-7411");

QString planted(const QString& where) {
  return kSentinel + QStringLiteral(" in ") + where;
}

/// A protocol of every kind of page that has a field for text: a consent form, a form with an item
/// of every type, a trial, an interview.
protocols::LoadedProtocol protocolWithWords() {
  auto json = nlohmann::ordered_json::parse(tests::protocolWithEverything());
  const auto talk = nlohmann::ordered_json::parse(
      R"({"id": "talk", "type": "interview", "instrument": "interview"})");
  auto& phases = json["phases"];
  phases.insert(phases.end(), talk);
  return tests::protocolFrom(json.dump(), {{"everything.json", tests::everythingInstrument()}});
}

class ErasedWords : public testing::Test {
 protected:
  void SetUp() override {
    open();
    QObject::connect(&watch_, &QTimer::timeout, &watch_, [] {
      auto* message = qobject_cast<MessageBox*>(QApplication::activeModalWidget());
      if (message == nullptr || message->topic() != MessageTopic::StepNotDone) return;
      ADD_FAILURE() << message->words().toStdString();
      message->reject();
    });
    watch_.start(50);
  }

  void open() {
    window_.emplace(*study_);
    window_->show();
    participant_.emplace(*window_);
    participant_->writes(planted(QStringLiteral("a page")));
  }

  /// Closes the session before, and begins the next participant's.
  void enrol() {
    if (window_->controller() != nullptr) {
      QTest::mouseClick(buttonSaying(&*window_, QStringLiteral("Close session")), Qt::LeftButton);
    }
    window_->enrol({.cohort = "surgeons", .runMode = RunMode::Live, .language = "en", .code = {}});
  }

  const Session& session() const { return window_->controller()->session(); }

  /// Presses a button of the operator that asks for a reason, and types one.
  void press(const QString& button) {
    bool isAsked = false;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &look, [&] {
      auto* question = qobject_cast<MessageBox*>(QApplication::activeModalWidget());
      if (question == nullptr) return;
      isAsked = true;
      question->setText(planted(button));
      question->accept();
    });
    look.start(10);
    auto* pressed = buttonSaying(&*window_, button);
    ASSERT_NE(pressed, nullptr) << button.toStdString();
    QTest::mouseClick(pressed, Qt::LeftButton);
    EXPECT_TRUE(isAsked) << button.toStdString();
  }

  void note() {
    auto* line = window_->findChild<ControlPanel*>()->findChild<QLineEdit*>();
    QTest::keyClicks(line, planted(QStringLiteral("a note")));
    QTest::keyClick(line, Qt::Key_Return);
    EXPECT_TRUE(line->text().isEmpty()) << "the note was not kept";
  }

  void stopATrial() {
    participant_->goTo(StepKind::Trial);
    participant_->cut(1);
    QTest::mouseClick(window_->findChild<ControlPanel*>()->stopButton(), Qt::LeftButton);
  }

  void close() {
    participant_.reset();
    window_.reset();
    study_.close();
  }

  /// The files with what was typed: of the study, of the station, and the window's settings.
  Texts filesWithWords() {
    const auto words = kSentinel.toStdString();
    auto files = tests::filesWith(study_.scratch() / ".", words);
    const fs::path settings = studioSettings().fileName().toStdString();
    if (fs::exists(settings) && tests::contentOf(settings).find(words) != std::string::npos) {
      files.push_back(settings.filename().string());
    }
    return files;
  }

  tests::MadeStudy study_{protocolWithWords()};
  std::optional<OperatorWindow> window_;
  std::optional<tests::Participant> participant_;
  QTimer watch_;  ///< a message would wait for ever
};

TEST_F(ErasedWords, OfParticipantsAndOperatorsAreInNoFileAfterTheErasure) {
  enrol();
  note();
  participant_->goTo(StepKind::Form);
  press(QStringLiteral("Pause…"));
  window_->controller()->resume();
  stopATrial();
  press(QStringLiteral("Repeat…"));
  press(QStringLiteral("Skip…"));
  participant_->takePart();
  EXPECT_EQ(session().state(), SessionState::Completed);
  for (const auto* end : {"Participant withdraws…", "Reject session…", "Device failed…"}) {
    enrol();
    stopATrial();
    press(QString::fromUtf8(end));
    EXPECT_TRUE(session().isOver()) << end;
  }
  std::size_t texts = 0;  // the control: the fields were there, and took what was typed
  for (const auto& row : storage::Records(study_->database()).answers()) {
    const auto* text = std::get_if<std::string>(&row.answer.response);
    if (text != nullptr && text->find(kSentinel.toStdString()) != std::string::npos) ++texts;
  }
  EXPECT_GE(texts, 6U);
  EXPECT_FALSE(study_->identities().names("P001").empty());
  close();
  EXPECT_EQ(filesWithWords(), Texts{"study.db"}) << "the control: events and names are sealed";

  study_.reopen();
  for (const auto* code : {"P001", "P002", "P003", "P004"}) {
    erase(*study_, {.participant = code, .reason = "asked for it"});
  }
  EXPECT_EQ(tests::problemsOf(*study_), "");
  study_.close();
  EXPECT_EQ(filesWithWords(), Texts{});
}

}  // namespace erased_words_test
}  // namespace study::gui
