#include "study/gui/operator/findings_dialog.h"

#include <algorithm>

#include <gtest/gtest.h>

#include <QLabel>

#include "study/gui/widgets/findings_table.h"

namespace study::gui {
namespace findings_dialog_test {

TEST(FindingsDialog, ChecksAgainOnRequest) {
  using haptics::devices::CheckResult;
  using haptics::devices::Finding;
  bool isPlugged = false;
  const auto check = [&] {
    const CheckResult result{
        .finding = isPlugged ? Finding::Pass : Finding::Fail,
        .what = base::Message::verbatim("port"),
        .measured = base::Message::verbatim(isPlugged ? "open" : "none"),
        .fix = base::Message::verbatim(isPlugged ? "" : "Plug the device in.")};
    return std::vector<FindingsDialog::PartFindings>{{"punch", {result}}};
  };
  FindingsDialog dialog(check(), FindingsDialog::Question::StartDespiteFailures, check, nullptr);
  const auto* verdict = dialog.findChild<QLabel*>(QStringLiteral("verdict"));
  EXPECT_EQ(verdict->text(), QStringLiteral("✕  Checks that failed: 1."));
  const auto warns = [&] {
    const auto labels = dialog.findChildren<QLabel*>();
    return std::ranges::any_of(labels, [&](const QLabel* label) {
      return label->isVisibleTo(&dialog) && label->text().contains(QStringLiteral("may jerk"));
    });
  };
  EXPECT_TRUE(warns());
  isPlugged = true;
  dialog.findChild<QPushButton*>(QStringLiteral("check-again"))->click();
  EXPECT_EQ(verdict->text(), QStringLiteral("✓  All checks passed."));
  EXPECT_FALSE(warns()) << "nothing is wrong any more";
  const auto* table = dialog.findChild<QTableWidget*>();
  ASSERT_EQ(table->rowCount(), 1);
  EXPECT_EQ(table->item(0, 3)->text(), QStringLiteral("Open"));
}

/// A finding in words of this test.
haptics::devices::CheckResult resultIn(
    haptics::devices::Finding finding, const char* what, const char* measured, const char* fix) {
  using base::Message;
  return {finding, Message::verbatim(what), Message::verbatim(measured), Message::verbatim(fix)};
}

TEST(FindingsTable, ShowsTheWorstFirstAndClaimsNoTestThatWasNotMade) {
  using haptics::devices::Finding;
  FindingsTable table(nullptr);
  table.show(
      {{"a", resultIn(Finding::Pass, "x", "1", ""), "", false},
       {"b", resultIn(Finding::Pass, "x", "1", "")},
       {"c", resultIn(Finding::Fail, "x", "1", "Do it.")},
       {"d", resultIn(Finding::Warn, "x", "1", "Look.")}});
  QString parts;
  for (int row = 0; row < table.rowCount(); ++row) parts += table.item(row, 0)->text();
  EXPECT_EQ(parts, QStringLiteral("CDBA"));
  EXPECT_EQ(table.item(3, 1)->text(), QStringLiteral("– not tested"));
  EXPECT_EQ(table.item(0, 1)->foreground().style(), Qt::NoBrush) << "the theme may change";
}

}  // namespace findings_dialog_test
}  // namespace study::gui
