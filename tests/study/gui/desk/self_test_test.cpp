#include "study/gui/desk/self_test.h"

#include <set>

#include <gtest/gtest.h>

#include <QHeaderView>
#include <QTest>

#include "protocols/load_protocol.h"
#include "study/gui/desk/self_test_dialog.h"
#include "study/session/study.h"
#include "tests/study/gui/pictures.h"
#include "tests/study/known_secret.h"
#include "tests/support/scratch_folder.h"

namespace study::gui {
namespace self_test_test {

using haptics::devices::Finding;

haptics::engine::RealtimeLoop::Report reportOf(std::uint64_t ticks, std::uint64_t late) {
  haptics::engine::RealtimeLoop::Report report{.ticks = ticks, .lateTicks = late};
  for (std::uint64_t i = 0; i < ticks; ++i) report.lateness.add(i < late ? 1500.0 : 20.0);
  return report;
}

TEST(SelfTest, JudgesTheClockByMissedTicksAndPriority) {
  EXPECT_EQ(evaluateTiming(reportOf(2000, 0), true, 1000.0).found.finding, Finding::Pass);
  EXPECT_EQ(evaluateTiming(reportOf(2000, 0), false, 1000.0).found.finding, Finding::Warn);
  EXPECT_EQ(evaluateTiming(reportOf(2000, 60), true, 1000.0).found.finding, Finding::Warn);
  const auto rough = evaluateTiming(reportOf(2000, 200), true, 1000.0).found;
  EXPECT_EQ(rough.finding, Finding::Fail);
  const auto measured = base::describe(rough.measured);
  EXPECT_NE(measured.find("200 of 2000"), std::string::npos) << measured;
  EXPECT_FALSE(rough.fix.empty());
  EXPECT_NE(
      evaluateTiming(reportOf(2000, 200), true, 1000.0).details.find("µs (median)"),
      std::string::npos);
}

TEST(SelfTest, JudgesTheDiskByTheTimeOfACommit) {
  const auto judge = [](double median) {
    const auto line =
        evaluateCommitTimes({.commits = 40, .median = median, .longest = 2.0 * median}, "/x");
    EXPECT_EQ(base::describe(line.found.measured).find("/x"), std::string::npos)
        << "the folder is a detail";
    EXPECT_NE(line.details.find("/x"), std::string::npos);
    return line.found;
  };
  EXPECT_EQ(judge(0.002).finding, Finding::Pass);
  EXPECT_EQ(judge(0.05).finding, Finding::Warn);
  EXPECT_EQ(judge(0.5).finding, Finding::Fail);
  EXPECT_TRUE(judge(0.002).fix.empty());
  EXPECT_FALSE(judge(0.5).fix.empty());
}

class StudySelfTest : public testing::Test {
 protected:
  void SetUp() override {
    questionnaires::Problems problems;
    const auto protocol = *protocols::loadProtocolFile("punch-face-validity", problems);
    Study::create(folder_ / "study", protocol, clock_, 7, tests::knownSecret());
  }

  std::vector<FindingLine> test() {
    return testComputer({.study = folder_ / "study", .seconds = 0.2}, {});
  }

  static const FindingLine* about(const std::vector<FindingLine>& lines, const std::string& what) {
    for (const auto& line : lines) {
      if (base::describe(line.found.what) == what) return &line;
    }
    return nullptr;
  }

  tests::ScratchFolder folder_;
  SystemClock clock_;
};

TEST_F(StudySelfTest, TestsEveryPartAndLeavesNoFiles) {
  const auto lines = test();
  std::set<std::string> parts;
  for (const auto& line : lines) {
    parts.insert(line.part);
    const auto what = base::describe(line.found.what);
    EXPECT_FALSE(line.found.measured.empty()) << what;
    EXPECT_EQ(line.found.fix.empty(), line.found.finding == Finding::Pass) << what;
  }
  EXPECT_EQ(parts, (std::set<std::string>{"devices", "saving", "timing"}));
  ASSERT_NE(about(lines, "answers"), nullptr);
  EXPECT_EQ(about(lines, "answers")->found.finding, Finding::Pass);
  for (const auto& entry : std::filesystem::directory_iterator(folder_ / "study")) {
    EXPECT_EQ(entry.path().filename().string().find("self-test"), std::string::npos)
        << entry.path();
  }
}

TEST_F(StudySelfTest, FindsADamagedDatabase) {
  std::filesystem::resize_file(folder_ / "study/traces.db", 5000);
  const auto lines = test();
  ASSERT_NE(about(lines, "recordings"), nullptr);
  EXPECT_EQ(about(lines, "recordings")->found.finding, Finding::Fail);
}

TEST_F(StudySelfTest, TestsTheDevicesOfTheDeviceFile) {
  folder_.write(
      "study/devices.json",
      R"({"format": "palpate-devices-1", "devices": [{"id": "punch", "type": "simulated-punch"}]})");
  const auto lines = test();
  bool knowsPunch = false;
  for (const auto& line : lines) {
    knowsPunch |= line.part == "devices" && base::describe(line.found.what).starts_with("punch: ");
  }
  EXPECT_TRUE(knowsPunch) << base::describe(lines.front().found.measured);
}

/// A finding in words of this test.
haptics::devices::CheckResult resultIn(
    haptics::devices::Finding finding, const char* what, const char* measured, const char* fix) {
  using base::Message;
  return {finding, Message::verbatim(what), Message::verbatim(measured), Message::verbatim(fix)};
}

TEST_F(StudySelfTest, ListsEachPartOnceAndTheOneWithTheWorstFindingFirst) {
  FindingsTable table(nullptr);
  table.show(
      {{"screen", resultIn(Finding::Pass, "desk", "1920 × 1080", "")},
       {"timing", resultIn(Finding::Fail, "clock", "late", "mend")},
       {"screen", resultIn(Finding::Warn, "second", "none", "connect")}});
  table.resize(900, 700);
  table.QWidget::show();
  EXPECT_EQ(table.item(0, 0)->text(), QStringLiteral("Timing"));
  EXPECT_EQ(table.item(1, 2)->text(), QStringLiteral("Second"));
  EXPECT_EQ(table.rowSpan(1, 0), 2);
  EXPECT_EQ(table.rowHeight(0), table.rowHeight(1)) << "two lines, of finding and advice";
  EXPECT_LT(table.rowHeight(2), table.rowHeight(1)) << "one line";
}

TEST_F(StudySelfTest, ShowsOneLineForEachPart) {
  SelfTestDialog dialog({.study = folder_ / "study", .seconds = 0.3});
  dialog.show();
  QTest::mouseClick(dialog.findChild<QPushButton*>(QStringLiteral("go")), Qt::LeftButton);
  auto* table = dialog.findChild<QTableWidget*>(QStringLiteral("lines"));
  std::set<std::string> parts;
  for (int row = 0; row < table->rowCount(); ++row) {
    parts.insert(table->item(row, 0)->text().toStdString());
  }
  EXPECT_EQ(parts, (std::set<std::string>{"Devices", "Saving", "Screen", "Timing"}));
  EXPECT_TRUE(dialog.findChild<QLabel*>(QStringLiteral("outcome"))->isVisible());
  const auto findings = [&] {
    QString words;
    for (int row = 0; row < table->rowCount(); ++row) words += table->item(row, 3)->text();
    return words;
  };
  auto* details = dialog.findChild<QCheckBox*>();
  EXPECT_FALSE(findings().contains(QStringLiteral("µs"))) << findings().toStdString();
  details->click();
  EXPECT_TRUE(findings().contains(QStringLiteral("µs"))) << findings().toStdString();
  details->click();
  tests::photographInAllThemes(dialog, QStringLiteral("self-test"));
}

}  // namespace self_test_test
}  // namespace study::gui
