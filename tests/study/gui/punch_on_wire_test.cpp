// The windows with an emulated punch on a pseudo-terminal. The emulator runs in this process.
#include <algorithm>
#include <atomic>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include <QDialog>
#include <QLabel>
#include <QPushButton>
#include <QTableWidget>
#include <QTest>
#include <QTimer>

#include "haptics/emulators/punch_emulator.h"
#include "haptics/timing/monotonic_clock.h"
#include "study/gui/operator/findings_dialog.h"
#include "study/gui/operator/operator_window.h"
#include "study/storage/records.h"
#include "tests/study/gui/participant.h"
#include "tests/study/known_secret.h"
#include "tests/study/made_study.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace punch_on_wire_test {

namespace timing = haptics::timing;
using haptics::emulators::PunchEmulator;

/// An emulated punch that runs in its own thread. Commands take effect between two iterations of
/// its
/// loop.
class RunningPunch {
 public:
  explicit RunningPunch(const PunchEmulator::Options& options)
      : punch_(options), loop_([this](const std::stop_token& stop) {
          timing::raisePriority(timing::kEmulatorPriority);
          for (std::int64_t due = timing::now(); !stop.stop_requested();
               due += timing::kMillisecond) {
            timing::sleepUntil(due);
            if (const char* order = order_.exchange(nullptr)) punch_.command(order);
            punch_.step();
          }
        }) {}

  void order(const char* line) { order_.store(line); }

 private:
  PunchEmulator punch_;
  std::atomic<const char*> order_{nullptr};
  std::jthread loop_;
};

/// A study on an emulated punch, in its own folder.
class ConnectedPunch : public testing::Test {
 protected:
  static PunchEmulator::Options optionsFor(const std::string& port) {
    PunchEmulator::Options options;
    options.link = port;
    options.person.closed = 13.8;
    return options;
  }

  tests::ScratchFolder folder_;
  std::string port_ = folder_ / "port";
  RunningPunch punch_{optionsFor(port_)};
  std::string devices_ = folder_.write(
      "devices.json",
      R"({"format": "palpate-devices-1", "devices": [{"id": "punch", "type": "punch-serial", "port": ")" +
          port_ + R"(", "newtons_per_volt": 0.667}]})");
  SystemClock clock_;
  Study study_ = Study::create(
      folder_ / "study",
      tests::filledIn(tests::libraryProtocol("punch-face-validity")),
      clock_,
      7,
      tests::knownSecret());
};

TEST_F(ConnectedPunch, RecoversFromBeingUnpluggedInATrial) {
  OperatorWindow window(study_, devices_);
  window.show();
  window.enrol({.cohort = "professional", .runMode = RunMode::Live, .language = "en", .code = {}});
  tests::Participant participant(window);
  const auto& plan = window.controller()->session().plan();
  int trial = 0;
  while (plan[static_cast<std::size_t>(trial)].kind != StepKind::Trial) ++trial;
  participant.takePart(trial);

  auto& controller = *window.controller();
  // A computer that stalls for longer than the punch's timeout also ends a trial: begin it again.
  const auto felt = [&](const auto& isOnDevice) {
    if (controller.session().state() == SessionState::Interrupted) {
      controller.repeatStep(QStringLiteral("again"));
      QTest::qWait(100);
    }
    if (!controller.isTrialRunning()) controller.beginTrial();
    return isOnDevice(controller.trialStatus());
  };
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return felt([](const auto& status) { return status.force > 0.5; }); }, 20'000));
  EXPECT_FALSE(controller.isDeviceVirtual());
  punch_.order("unplug");
  ASSERT_TRUE(QTest::qWaitFor([&] { return !controller.isTrialRunning(); }, 5000));
  EXPECT_EQ(controller.session().state(), SessionState::Interrupted);
  EXPECT_EQ(storage::Records(study_.database()).trials().back().ending, TrialEnding::DeviceGone);

  punch_.order("plug");
  QTest::qWait(100);
  const int cuts = controller.session().step().minimumCuts;
  ASSERT_TRUE(QTest::qWaitFor(
      [&] { return felt([&](const auto& status) { return status.cuts >= cuts; }); }, 120'000));
  controller.finishTrial();
  EXPECT_EQ(window.controller()->session().stepIndex(), trial + 1);
  EXPECT_EQ(storage::Records(study_.database()).trials().back().ending, TrialEnding::Finished);
}

/// Returns the rows of the findings dialog and closes it.
std::vector<QStringList> readFindings(QWidget& window) {
  std::vector<QStringList> rows;
  QTimer look;
  QObject::connect(&look, &QTimer::timeout, &look, [&] {
    for (auto* dialog : window.findChildren<QDialog*>()) {
      auto* table = dialog->findChild<QTableWidget*>();
      if (table == nullptr || !dialog->isVisible()) continue;
      for (int row = 0; row < table->rowCount(); ++row) {
        auto& cells = rows.emplace_back();
        for (int column = 0; column < table->columnCount(); ++column) {
          cells << table->item(row, column)->text();
        }
      }
      tests::photograph(*dialog, QStringLiteral("check-devices"));
      dialog->reject();
    }
  });
  look.start(100);
  QTest::mouseClick(
      window.findChild<QPushButton*>(QStringLiteral("check-devices")), Qt::LeftButton);
  return rows;
}

TEST_F(ConnectedPunch, CanBeCheckedFromTheWindow) {
  OperatorWindow window(study_, devices_);
  window.show();
  auto sound = readFindings(window);
  // A computer that stalls for longer than the punch's timeout also fails a check.
  for (int i = 0; i < 4 && sound.size() < 8; ++i) sound = readFindings(window);
  ASSERT_GE(sound.size(), 8U);
  for (const auto& row : sound) {
    EXPECT_EQ(row[0], QStringLiteral("Punch"));
    EXPECT_FALSE(row[1].endsWith(QStringLiteral("fix it"))) << row.join(u' ').toStdString();
    EXPECT_FALSE(row[3].isEmpty()) << row[2].toStdString();
  }
  EXPECT_TRUE(std::any_of(sound.begin(), sound.end(), [](const auto& row) {
    return row[1].endsWith(QStringLiteral("good"));
  }));

  punch_.order("unplug");
  QTest::qWait(300);
  const auto gone = readFindings(window);
  ASSERT_FALSE(gone.empty());
  EXPECT_TRUE(gone.front()[1].endsWith(QStringLiteral("fix it")));
  EXPECT_TRUE(gone.front()[3].contains(QStringLiteral("\n→ "))) << "there is advice";
  auto* line = window.findChild<QLabel*>(QStringLiteral("device-punch"));
  EXPECT_TRUE(line->text().contains(QStringLiteral("unplugged"))) << line->text().toStdString();
  EXPECT_TRUE(line->text().contains(QStringLiteral("“Check devices…”"))) << "it says what to do";
  window.resize(1280, 720);
  tests::photograph(window, QStringLiteral("unplugged"));
}

TEST_F(ConnectedPunch, AsksBeforeASessionIfItsCheckFails) {
  OperatorWindow window(study_, devices_);
  window.show();
  punch_.order("unplug");
  QTest::qWait(300);
  // Enter answers no. Yes must be selected.
  const auto begin = [&](const auto& answer) {
    int asked = 0;
    QTimer look;
    QObject::connect(&look, &QTimer::timeout, &look, [&] {
      auto* question = window.findChild<FindingsDialog*>();
      if (question == nullptr || !question->isVisible()) return;
      ++asked;
      answer(*question);
    });
    look.start(100);
    tests::chooseFirstCohort(window);
    QTest::mouseClick(
        tests::buttonSaying(&window, QStringLiteral("New participant")), Qt::LeftButton);
    return asked;
  };
  EXPECT_EQ(begin([](FindingsDialog& question) { QTest::keyClick(&question, Qt::Key_Return); }), 1);
  EXPECT_EQ(window.controller(), nullptr) << "No is the default";
  EXPECT_EQ(
      begin([](FindingsDialog& question) {
        QTest::mouseClick(
            tests::buttonSaying(&question, QStringLiteral("Start anyway")), Qt::LeftButton);
      }),
      1);
  EXPECT_NE(window.controller(), nullptr);
}

}  // namespace punch_on_wire_test
}  // namespace study::gui
