// Walks through every window of the program: what can be read, reached, seen and said of it.
#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <QApplication>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QTest>

#include "haptics/devices/messages.h"
#include "haptics/engine/built_in_models.h"
#include "haptics/recordings/recording.h"
#include "protocols/load_protocol.h"
#include "protocols/model/loaded_protocol.h"
#include "study/cohort/simulated_participant.h"
#include "study/gui/authoring/preview_window.h"
#include "study/gui/authoring/protocol_window.h"
#include "study/gui/authoring/texts_dialog.h"
#include "study/gui/desk/erase_dialog.h"
#include "study/gui/desk/export_dialog.h"
#include "study/gui/desk/help_window.h"
#include "study/gui/desk/key_dialog.h"
#include "study/gui/desk/measurement_dialogs.h"
#include "study/gui/desk/new_study_dialog.h"
#include "study/gui/desk/self_test_dialog.h"
#include "study/gui/desk/shape_window.h"
#include "study/gui/desk/study_dialogs.h"
#include "study/gui/desk/study_summary.h"
#include "study/gui/desk/task_dialogs.h"
#include "study/gui/desk/tour.h"
#include "study/gui/home/home_window.h"
#include "study/gui/operator/findings_dialog.h"
#include "study/gui/operator/operator_window.h"
#include "study/gui/operator/page_mirror.h"
#include "study/gui/scene/bone_colours_window.h"
#include "study/gui/session/operator_pin.h"
#include "study/gui/widgets/background_task.h"
#include "study/gui/widgets/desk_language.h"
#include "study/gui/widgets/message_box.h"
#include "study/gui/widgets/mnemonics.h"
#include "study/gui/widgets/studio_settings.h"
#include "study/gui/widgets/theme.h"
#include "study/words/words.h"
#include "tests/haptics/recordings/made_recording.h"
#include "tests/study/gui/participant.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/gui/window_checks.h"
#include "tests/study/known_secret.h"
#include "tests/study/made_study.h"
#include "tests/support/long_form.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace window_walk_test {

/// A window that is open, with what it needs.
struct Opened {
  std::shared_ptr<void> keeper;  ///< of what the window shows; destroyed after the window
  std::shared_ptr<QWidget> window;
};

/// Makes every window of the program, with something in it to see.
class Windows {
 public:
  Windows() : protocol_(shipped("punch-face-validity")) {
    Study::create(folder_ / "study", tests::filledIn(protocol_), clock_, 7, tests::knownSecret());
  }

  /// By the name of its class, and of a state after "_" where one is not enough.
  std::map<std::string, std::function<Opened()>> all() {
    return {
        {"AmendDialog", [this] { return make<AmendDialog>(summary()); }},
        {"BackgroundTask", [] { return make<BackgroundTask>(QStringLiteral("Verify"), waits()); }},
        {"BackupDialog", [this] { return make<BackupDialog>(summary()); }},
        {"BuildBoneDialog", [] { return make<BuildBoneDialog>(); }},
        {"BoneColoursWindow", [] { return cup(); }},
        {"EraseDialog", [this] { return make<EraseDialog>(withPeople()); }},
        {"ExportDialog", [this] { return make<ExportDialog>(withPeople()); }},
        {"FindingsDialog", [] { return findings(); }},
        {"FitMaterialDialog", [] { return make<FitMaterialDialog>(); }},
        {"HelpWindow", [] { return make<HelpWindow>(); }},
        {"HomeWindow", [this] { return home(); }},
        {"HomeWindow_Empty", [] { return emptyHome(); }},
        {"ImportCutDialog", [] { return make<ImportCutDialog>(); }},
        {"ImportCutDialog_Table", [this] { return importOfTable(); }},
        {"KeyDialog", [this] { return make<KeyDialog>(summary()); }},
        {"MessageBox", [] { return message(); }},
        {"MessageBox_Question",
         [] {
           return make<MessageBox>(
               MessageTopic::RepeatStep,
               QStringLiteral("7|Round 1: Alternative\u00a02").split('|'),
               QString());
         }},
        {"NewStudyDialog", [] { return make<NewStudyDialog>(); }},
        {"OperatorWindow", [this] { return desk(); }},
        {"OperatorWindow_Sessions", [this] { return betweenSessions(); }},
        {"PageMirror", [] { return make<PageMirror>(nullptr); }},
        {"ParticipantWindow", [this] { return participant(); }},
        {"PinDialog", [] { return make<PinDialog>(); }},
        {"PlanDialog", [this] { return make<PlanDialog>(summary()); }},
        {"PlanDialog_Done", [this] { return done<PlanDialog>(summary()); }},
        {"PreviewWindow", [this] { return make<PreviewWindow>(protocol_); }},
        {"ProtocolWindow",
         [] { return make<ProtocolWindow>(QStringLiteral("punch-face-validity")); }},
        {"ReportDialog", [this] { return make<ReportDialog>(summary()); }},
        {"SelfTestDialog", [] { return make<SelfTestDialog>(SelfTestOptions{.seconds = 0.1}); }},
        {"SelfTestDialog_Done", [] { return selfTest(); }},
        {"SimulateDialog", [this] { return make<SimulateDialog>(summary()); }},
        {"SimulationView", [] { return knee(); }},
        {"StatisticsDialog", [this] { return make<StatisticsDialog>(summary()); }},
        {"StatisticsDialog_Done", [this] { return done<StatisticsDialog>(simulated()); }},
        {"TextsDialog", [this] { return make<TextsDialog>(protocol_); }},
        {"Tour", [] { return make<Tour>(); }},
        {"VerifyDialog", [this] { return make<VerifyDialog>(summary()); }},
        {"VerifyDialog_Done", [this] { return done<VerifyDialog>(summary()); }},
    };
  }

 private:
  static protocols::LoadedProtocol shipped(const std::string& name) {
    questionnaires::Problems problems;
    return *protocols::loadProtocolFile(name, problems);
  }

  template <typename Window, typename... Arguments>
  static Opened make(Arguments&&... arguments) {
    return {nullptr, std::make_shared<Window>(std::forward<Arguments>(arguments)...)};
  }

  /// A dialog whose work is done.
  template <typename Dialog>
  static Opened done(const StudySummary& summary) {
    auto opened = make<Dialog>(summary);
    opened.window->template findChild<QPushButton*>(QStringLiteral("go"))->click();
    return opened;
  }

  /// A study with simulated participants.
  StudySummary simulated() {
    const std::string folder = folder_ / "simulated";
    if (!std::filesystem::exists(folder)) {
      SimulatedClock clock;
      auto study = Study::create(folder, protocol_, clock, 7, tests::knownSecret());
      simulateCohorts(study, clock, 4, 7, [](const auto&) {});
    }
    return summaryOf(folder);
  }

  /// A study with participants who have just begun.
  StudySummary withPeople() {
    const std::string folder = folder_ / "people";
    if (!std::filesystem::exists(folder)) {
      auto study =
          Study::create(folder, tests::filledIn(protocol_), clock_, 7, tests::knownSecret());
      for (int i = 0; i < 4; ++i) {
        study::Session::enrol(study, {.cohort = "professional", .runMode = RunMode::Live});
      }
    }
    return summaryOf(folder);
  }

  static BackgroundTask::Work waits() {
    return [](const Progress& progress) {
      for (;;) {
        progress(0.4, "reading the recording of session 5 of 12");
        std::this_thread::sleep_for(std::chrono::milliseconds(5));
      }
    };
  }

  static Opened findings() {
    using haptics::devices::deviceMessage;
    using haptics::devices::Finding;
    const std::vector<haptics::devices::CheckResult> results{
        {Finding::Pass,
         deviceMessage("check.firmware"),
         deviceMessage("check.firmware.found", 1, 7, 12.0, 1000)},
        {Finding::Pass,
         deviceMessage("check.telemetry"),
         deviceMessage("check.telemetry.rate", 999.0, 1000.0)},
        {Finding::Warn,
         deviceMessage("check.round_trip"),
         deviceMessage("check.median_and_p99", 1210.0, 4100.0),
         deviceMessage("check.round_trip.fix")},
        {Finding::Fail,
         deviceMessage("check.board_faults"),
         deviceMessage("check.board_faults.encoder"),
         deviceMessage("check.board_faults.fix")}};
    const std::vector<FindingsDialog::PartFindings> found{{"punch", results}};
    return make<FindingsDialog>(
        found, FindingsDialog::Question::StartDespiteFailures, [found] { return found; }, nullptr);
  }

  Opened home() {
    auto opened = make<HomeWindow>();
    static_cast<HomeWindow&>(*opened.window).choose(QString::fromStdString(folder_ / "study"));
    return opened;
  }

  static Opened emptyHome() {
    studioSettings().clear();
    return make<HomeWindow>();
  }

  /// Of a table that the punch's recorder did not write.
  Opened importOfTable() {
    std::string table = "t_ms\tLoad cell [g]\tHandle [deg]\n";
    for (const auto& row : haptics::recordings::readRecording(tests::textOf({})).rows) {
      table += fmt::format("{}\t{}\t{}\n", row.time, row.reading, 48.0 - row.travel);
    }
    auto opened = make<ImportCutDialog>();
    opened.window->findChild<PathField*>(QStringLiteral("recording"))
        ->setPath(QString::fromStdString(folder_.write("table.txt", table)));
    return opened;
  }

  static Opened selfTest() {
    auto opened = make<SelfTestDialog>(SelfTestOptions{.seconds = 0.1});
    static_cast<SelfTestDialog&>(*opened.window).test();
    return opened;
  }

  static Opened message() {
    return make<MessageBox>(
        MessageTopic::ReportNotWritten,
        QStringList(),
        QStringLiteral("~/reports/punch.html cannot be written: the disk is full. Free some space "
                       "and try again."));
  }

  StudySummary summary() { return summaryOf(folder_ / "study"); }
  static Opened knee() { return {nullptr, std::shared_ptr<QWidget>(openBuiltInKnee(nullptr))}; }

  struct Idle {
    explicit Idle(Study opened) : study(std::move(opened)), window(study) {}
    Study study;
    OperatorWindow window;
  };

  /// "Next participant".
  Opened betweenSessions() {
    auto idle = std::make_shared<Idle>(Study::open(folder_ / "study", clock_));
    idle->window.setWindowState(Qt::WindowNoState);
    return {idle, std::shared_ptr<QWidget>(idle, &idle->window)};
  }

  struct Session {
    explicit Session(Study opened) : study(std::move(opened)), window(study) {
      window.enrol(
          {.cohort = "professional", .runMode = RunMode::Pilot, .language = "en", .code = {}});
    }
    Study study;
    OperatorWindow window;
  };

  Opened desk() {
    auto session = std::make_shared<Session>(Study::open(folder_ / "study", clock_));
    session->window.setWindowState(Qt::WindowNoState);
    return {session, std::shared_ptr<QWidget>(session, &session->window)};
  }

  Opened participant() {
    auto session = std::make_shared<Session>(Study::open(folder_ / "study", clock_));
    return {session, std::shared_ptr<QWidget>(session, session->window.participantWindow())};
  }

  static Opened cup() {
    const auto spec = std::make_shared<haptics::engine::PackingSpec>(
        haptics::engine::PackingSpec{.bone = haptics::engine::parametricBone()});
    return {
        spec, std::make_shared<scene::BoneColoursWindow>(*spec, scene::BoneColoursWindow::Trial{})};
  }

  protocols::LoadedProtocol protocol_;
  tests::ScratchFolder folder_;
  SystemClock clock_;
};

Windows& windows() {
  static Windows made;
  return made;
}

enum class Check { Contrast, Room, Keyboard, Names, Mnemonics, Order };

/// What is known to be wrong and not mended yet. An entry that describes nothing fails.
struct KnownFlaw {
  std::string window;
  Check check;
  std::string part;  ///< of the lines that describe it
};
const std::vector<KnownFlaw> kKnownFlaws;

class WindowWalk : public testing::TestWithParam<std::string> {
 protected:
  void SetUp() override { open("en"); }
  void TearDown() override {
    close();
    setDeskLanguage("en");
    applyTheme(*qobject_cast<QApplication*>(QApplication::instance()));
  }

  void open(std::string_view language) {
    close();
    setDeskLanguage(language);
    opened_ = windows().all().at(GetParam())();
    window().show();
    window().activateWindow();
    QApplication::processEvents();
  }
  void close() {
    opened_.window.reset();  // before what it shows
    opened_.keeper.reset();
  }

  QWidget& window() { return *opened_.window; }

  void expectNone(Check check, const QStringList& flaws) {
    std::set<const KnownFlaw*> unseen;
    for (const auto& known : kKnownFlaws) {
      if (known.window == GetParam() && known.check == check) unseen.insert(&known);
    }
    const auto here = unseen;
    for (const auto& flaw : flaws) {
      const auto line = flaw.toStdString();
      const auto known = std::find_if(here.begin(), here.end(), [&](const KnownFlaw* each) {
        return line.find(each->part) != std::string::npos;
      });
      if (known == here.end()) {
        ADD_FAILURE() << GetParam() << ": " << line;
      } else {
        unseen.erase(*known);
      }
    }
    for (const auto* known : unseen) ADD_FAILURE() << "mended: " << known->part;
  }

  Opened opened_;
};

TEST(WindowWalkList, HasEveryWindowOfTheProgram) {
  std::set<std::string> walked;
  for (const auto& [name, make] : windows().all()) walked.insert(name.substr(0, name.find('_')));
  std::set<std::string> all;
  for (const auto& window : programWindows()) all.emplace(window.name);
  all.erase("QFileDialog");  // the desktop's own
  EXPECT_EQ(walked, all);
}

TEST_P(WindowWalk, CanBeReadInEveryTheme) {
  auto& application = *qobject_cast<QApplication*>(QApplication::instance());
  QStringList flaws;
  auto* focused = window().focusWidget();
  for (const auto theme : {ThemeName::Light, ThemeName::Dark, ThemeName::HighContrast}) {
    applyTheme(application, theme);
    flaws << tests::unreadableTexts(window(), 4.5);
  }
  if (focused != nullptr) focused->setFocus();  // the picture shows the window as it opens
  expectNone(Check::Contrast, flaws);
  tests::photographInAllThemes(window(), QString::fromStdString("walk-" + GetParam()));
}

TEST_P(WindowWalk, FitsEveryScreenInEveryLanguage) {
  QStringList flaws;
  for (const auto& language : words::languages()) {
    if (language != deskLanguage()) open(language);
    // A scale of 150 or 200 % leaves a window the fewer pixels of its own.
    const bool isDialog = qobject_cast<QDialog*>(&window()) != nullptr;
    const QSize natural = window().size();
    const bool isSample = language != "en" && !tests::isLong();
    const std::vector<QSize> sample{{1024, 700}, {683, 384}};
    const std::vector<QSize> all{
        {1024, 700}, {1366, 768}, {911, 512}, {683, 384}, {1920, 1080}, {960, 540}, {3840, 2160}};
    for (const QSize screen : isSample ? sample : all) {
      const auto size = isDialog ? natural.boundedTo(screen) : screen;
      for (const auto& flaw : tests::cutOffAt(window(), size)) {
        flaws << QString::fromStdString(language) + QLatin1Char(' ') + flaw;
      }
      tests::photograph(
          window(),
          QStringLiteral("walk-%1-%2-%3")
              .arg(QString::fromStdString(GetParam()), QString::fromStdString(language))
              .arg(screen.width()));
    }
  }
  expectNone(Check::Room, flaws);
}

TEST_P(WindowWalk, HasAMnemonicForEveryButtonAndMenu) {
  addMnemonics(window());
  expectNone(Check::Mnemonics, tests::textsWithoutMnemonic(window()));
}

TEST_P(WindowWalk, BeginsAtAFieldAndHasItsActionAtTheRightEnd) {
  if (qobject_cast<QDialog*>(&window())) expectNone(Check::Order, tests::outOfOrder(window()));
}

TEST_P(WindowWalk, CanBeUsedByKeyboard) {
  expectNone(Check::Keyboard, tests::lostFocus(window()));
}

TEST_P(WindowWalk, IsNamedForAScreenReader) {
  expectNone(Check::Names, tests::unnamedElements(window()));
}

INSTANTIATE_TEST_SUITE_P(
    Every,
    WindowWalk,
    testing::Values(
        "AmendDialog",
        "BackgroundTask",
        "BackupDialog",
        "BuildBoneDialog",
        "BoneColoursWindow",
        "EraseDialog",
        "ExportDialog",
        "FindingsDialog",
        "FitMaterialDialog",
        "HelpWindow",
        "HomeWindow",
        "HomeWindow_Empty",
        "ImportCutDialog",
        "ImportCutDialog_Table",
        "KeyDialog",
        "MessageBox",
        "MessageBox_Question",
        "NewStudyDialog",
        "OperatorWindow",
        "OperatorWindow_Sessions",
        "PageMirror",
        "ParticipantWindow",
        "PinDialog",
        "PlanDialog",
        "PlanDialog_Done",
        "PreviewWindow",
        "ProtocolWindow",
        "ReportDialog",
        "SelfTestDialog",
        "SelfTestDialog_Done",
        "SimulateDialog",
        "SimulationView",
        "StatisticsDialog",
        "StatisticsDialog_Done",
        "TextsDialog",
        "Tour",
        "VerifyDialog",
        "VerifyDialog_Done"),
    [](const auto& each) { return each.param; });

/// Every message and question, each with what it may have to show.
class MessageWalk : public testing::Test {
 protected:
  void TearDown() override { setDeskLanguage("en"); }

  static std::unique_ptr<MessageBox> boxOf(const MessageRow& row) {
    const bool hasBlanks = row.topic == MessageTopic::LiveSessionHasBlanks ||
                           row.topic == MessageTopic::PilotSessionHasBlanks;
    const QString why =
        row.kind == MessageRow::Kind::Failure
            ? QStringLiteral("Could not save: the disk is full. Free 20 MB, and try again.")
        : hasBlanks ? QStringLiteral("•  consent-punch: [[institution]]\n•  debrief: [[contact]]")
                    : QString();
    auto box = std::make_unique<MessageBox>(
        row.topic,
        QStringList{
            hasBlanks ? QStringLiteral("12") : QStringLiteral("desk-2"),
            QStringLiteral("2026-03-09 08:15")},
        why);
    if (row.field == MessageRow::Field::Choice) box->setChoices({QStringLiteral("one")});
    box->show();
    box->activateWindow();
    QApplication::processEvents();
    return box;
  }
};

TEST_F(MessageWalk, HasNoFlawInAnyMessageInAnyLanguage) {
  for (const auto& language : words::languages()) {
    setDeskLanguage(language);
    for (const auto& row : messages()) {
      const auto box = boxOf(row);
      const auto expectNone = [&](const QStringList& flaws) {
        for (const auto& flaw : flaws) {
          ADD_FAILURE() << language << " '" << row.headline << "': " << flaw.toStdString();
        }
      };
      const auto natural = box->size();
      for (const QSize screen : {QSize(683, 384), QSize(1366, 768)}) {
        expectNone(tests::cutOffAt(*box, natural.boundedTo(screen)));
      }
      box->resize(natural);
      tests::photograph(
          *box,
          QStringLiteral("message-%1-%2")
              .arg(QString::fromStdString(language))
              .arg(static_cast<int>(row.topic), 2, 10, QLatin1Char('0')));
      if (language != "en") continue;
      expectNone(tests::unreadableTexts(*box, 4.5));
      expectNone(tests::unnamedElements(*box));
      expectNone(tests::lostFocus(*box));
    }
  }
}

TEST_F(MessageWalk, HasRoomForLongWordsInEveryLanguageAndTheme) {
  const QString path = QStringLiteral("/media/anna/A disk with a long name/studies of this year");
  for (const auto& language : words::languages()) {
    setDeskLanguage(language);
    for (const auto& row : messages()) {
      MessageBox box(row.topic, {path, path}, path + QStringLiteral(" cannot be read. ") + path);
      box.show();
      box.activateWindow();
      for (const auto theme : {ThemeName::Dark, ThemeName::Light}) {
        QApplication::processEvents();
        for (const auto* label : box.findChildren<QLabel*>()) {
          EXPECT_GE(label->height(), label->heightForWidth(label->width()))
              << language << ": " << label->text().toStdString();
        }
        applyTheme(*qobject_cast<QApplication*>(QApplication::instance()), theme);
      }
    }
  }
}

TEST_F(MessageWalk, SaysWhatHappenedAndWhatItMeansAndLeavesTheSafeButtonTheDefault) {
  for (const auto& row : messages()) {
    const auto box = boxOf(row);
    EXPECT_STRNE(row.title, "") << row.headline;
    EXPECT_STRNE(row.data, "") << row.headline;
    const bool isError = row.kind == MessageRow::Kind::Failure;
    EXPECT_TRUE(
        isError || row.topic == MessageTopic::FileSaved || *row.advice != '\0' ||
        *row.action != '\0')
        << row.headline << " does not say what to do";
    EXPECT_EQ(row.kind == MessageRow::Kind::Question, *row.action != '\0') << row.headline;
    auto* safe = box->findChild<QPushButton*>(QStringLiteral("safe"));
    const bool isChoice = row.field == MessageRow::Field::Choice;
    EXPECT_EQ(safe->isDefault(), !isChoice) << row.headline;
    if (row.field == MessageRow::Field::None) EXPECT_TRUE(safe->hasFocus()) << row.headline;
    if (row.field == MessageRow::Field::NeededText) {
      EXPECT_FALSE(box->findChild<QPushButton*>(QStringLiteral("action"))->isEnabled());
      auto* obstacle = box->findChild<QLabel*>(QStringLiteral("obstacle"));
      EXPECT_TRUE(obstacle->isVisible() && !obstacle->text().isEmpty()) << row.headline;
      box->setText(QStringLiteral("a"));
      EXPECT_FALSE(obstacle->isVisible()) << row.headline;
    }
    for (const std::string bare : {"Yes", "No", "OK", "Cancel"}) {
      EXPECT_NE(row.safe, bare) << row.headline;
      EXPECT_NE(row.action, bare) << row.headline;
    }
  }
}

TEST_F(MessageWalk, LeavesTheFocusOnNotStartingWhereADeviceFailed) {
  const auto opened = windows().all().at("FindingsDialog")();
  opened.window->show();
  opened.window->activateWindow();
  QApplication::processEvents();
  const auto* focused = qobject_cast<QPushButton*>(opened.window->focusWidget());
  ASSERT_NE(focused, nullptr);
  EXPECT_EQ(focused->text().remove(u'&'), QStringLiteral("Do not start"));
  EXPECT_TRUE(focused->isDefault());
}

TEST_F(MessageWalk, DoesWhatIsAskedOnEnterOnceAReasonIsTyped) {
  const auto box = boxOf(messageAbout(MessageTopic::TakeOver));
  auto* action = box->findChild<QPushButton*>(QStringLiteral("action"));
  EXPECT_FALSE(action->isEnabled()) << "the reason is needed";
  QTest::keyClicks(QApplication::focusWidget(), QStringLiteral("the computer is gone"));
  EXPECT_TRUE(action->isDefault());
  QTest::keyClick(QApplication::focusWidget(), Qt::Key_Return);
  EXPECT_EQ(box->result(), QDialog::Accepted);
}

}  // namespace window_walk_test
}  // namespace study::gui
