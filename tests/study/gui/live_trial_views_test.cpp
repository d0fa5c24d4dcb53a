// The operator's displays of a running trial: plot, timing and cuts.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <gtest/gtest.h>

#include "haptics/devices/iiwa/reamer_kind.h"
#include "haptics/devices/punch/punch_kind.h"
#include "haptics/engine/force_limiter.h"
#include "haptics/registry/device_kinds.h"
#include "study/gui/operator/cut_table.h"
#include "study/gui/operator/live_plot.h"
#include "study/gui/operator/servo_panel.h"
#include "study/gui/operator/travel_plot.h"
#include "study/gui/participant/trial_page.h"
#include "study/gui/session/servo_health.h"
#include "study/gui/widgets/labels.h"
#include "study/words/words.h"

namespace study::gui {
namespace live_trial_views_test {

using haptics::engine::ForceLimiter;
using haptics::engine::TickSample;

TickSample sampleAt(std::uint64_t tick, double travel, double force) {
  TickSample sample;
  sample.tick = tick;
  sample.travel = travel;
  sample.force = force;
  sample.status = haptics::devices::DeviceStatus::Ok;
  return sample;
}

TEST(LivePlot, KeepsEveryPeakOfTheLastTenSeconds) {
  LivePlot plot;
  plot.begin(haptics::devices::punchKind(), 1000.0);
  for (std::uint64_t tick = 0; tick < 25'000; ++tick) {
    // One tick within the last ten seconds has a larger force than all others.
    plot.add(
        sampleAt(tick, 0.0, tick == 20'003 ? 7.5 : std::sin(0.01 * static_cast<double>(tick))));
  }
  plot.refresh();
  const auto force = plot.channel(0);
  double largest = 0.0;
  double largestAt = 0.0;
  for (const auto& point : force) {
    if (point.y() <= largest) continue;
    largest = point.y();
    largestAt = point.x();
  }
  EXPECT_EQ(largest, 7.5);
  EXPECT_NEAR(largestAt, 20.003, 1e-9);
  EXPECT_GE(force.front().x(), 25.0 - LivePlot::kShown - LivePlot::kSlice);
  const auto most = static_cast<std::size_t>(2.0 * LivePlot::kShown / LivePlot::kSlice) + 4;
  EXPECT_LE(force.size(), most);
  EXPECT_GT(force.size(), most / 3);
}

TEST(LivePlot, DrawsPointsInOrderOfTime) {
  LivePlot plot;
  plot.begin(haptics::devices::punchKind(), 8000.0);
  for (std::uint64_t tick = 0; tick < 40'000; ++tick) {
    plot.add(sampleAt(tick, std::cos(0.02 * static_cast<double>(tick)), 0.0));
  }
  double before = -1.0;
  const auto travel = plot.channel(1);
  for (const auto& point : travel) {
    EXPECT_GE(point.x(), before);
    before = point.x();
  }
}

TEST(ServoHealth, CountsLatenessInTheRightBars) {
  ServoHealth health;
  for (const float late : {0.0F, 10.0F, 11.0F, 20.0F, 999.0F, 1000.0F, 1001.0F, -3.0F}) {
    auto sample = sampleAt(0, 0.0, 0.0);
    sample.lateness = late;
    health.add(sample);
  }
  const std::array<std::uint64_t, 8> expected{3, 2, 0, 0, 0, 0, 2, 1};
  EXPECT_EQ(health.bars(), expected);
  EXPECT_EQ(health.ticks(), 8U);
  EXPECT_EQ(health.largestLateness(), 1001.0);
}

TEST(ServoHealth, CountsLimitedAndInvalidTicksAndTracksEnergy) {
  ServoHealth health;
  for (int i = 0; i < 10; ++i) {
    auto sample = sampleAt(0, 0.0, 0.0);
    sample.energy = i == 4 ? -0.5 : 2.0;
    if (i < 3) sample.interventions = ForceLimiter::Saturated;
    if (i == 9) sample.marks = TickSample::Invalid;
    health.add(sample);
  }
  EXPECT_DOUBLE_EQ(health.saturatedShare(), 0.3);
  EXPECT_DOUBLE_EQ(health.invalidShare(), 0.1);
  EXPECT_EQ(health.energy(), 2.0);
  EXPECT_EQ(health.leastEnergy(), -0.5);
}

TEST(ServoPanel, ShowsNoNumbersBeforeATrial) {
  ServoPanel panel;
  auto* words = panel.findChild<QLabel*>(QStringLiteral("servo-health"));
  EXPECT_EQ(words->text(), QStringLiteral("Nothing is felt just now."));
  panel.begin(haptics::devices::reamerKind(), 1000.0);
  auto sample = sampleAt(1, 0.0, 0.0);
  sample.lateness = 37.0F;
  panel.add(sample);
  panel.refresh();
  EXPECT_TRUE(words->text().contains(QStringLiteral("of 1000 Hz"))) << words->text().toStdString();
  EXPECT_TRUE(words->text().contains(QStringLiteral("largest 37 µs")));
  EXPECT_TRUE(words->text().contains(QStringLiteral("0.00 J")));
  panel.begin(haptics::devices::punchKind(), 1000.0);
  panel.add(sample);
  panel.refresh();
  EXPECT_TRUE(words->text().contains(QStringLiteral("0.00 N·units")))
      << "the travel of a handle is not in metres";
}

TEST(ServoPanel, SaysInOneLineWhetherTheTimingIsGood) {
  ServoPanel panel;
  const auto* light = panel.findChild<QLabel*>(QStringLiteral("timing"));
  panel.begin(haptics::devices::punchKind(), 1000.0);
  const auto tick = [&](double lateness, int times) {
    auto sample = sampleAt(1, 0.0, 0.0);
    sample.lateness = static_cast<float>(lateness);
    for (int i = 0; i < times; ++i) panel.add(sample);
    panel.refresh();
    return light->text();
  };
  EXPECT_TRUE(tick(20.0, 9990)
                  .startsWith(QStringLiteral("● Timing: good (none of 9990 force updates late)")));
  EXPECT_TRUE(
      tick(5000.0, 1).startsWith(QStringLiteral("● Timing: good (1 of 9991 force updates late)")));
  EXPECT_EQ(light->property("role").toString(), QStringLiteral("good"))
      << "the trial gets no warning";
  EXPECT_TRUE(tick(5000.0, 2000).startsWith(QStringLiteral("✖ Timing: poor")));
  auto* details = panel.findChild<QPushButton*>(QStringLiteral("timing-details"));
  const auto* words = panel.findChild<QLabel*>(QStringLiteral("servo-health"));
  EXPECT_TRUE(words->isHidden() || words->parentWidget()->isHidden());
  details->click();
  EXPECT_FALSE(words->parentWidget()->isHidden());
}

TEST(ServoPanel, SaysInALineOfItsOwnThatTheForceWasAtItsLimit) {
  ServoPanel panel;
  const auto* timing = panel.findChild<QLabel*>(QStringLiteral("timing"));
  const auto* light = panel.findChild<QLabel*>(QStringLiteral("limit"));
  panel.begin(haptics::devices::punchKind(), 1000.0);
  for (int i = 0; i < 10; ++i) {
    auto sample = sampleAt(1, 5.0, 8.0);
    if (i < 3) sample.interventions = ForceLimiter::Saturated;
    panel.add(sample);
  }
  panel.refresh();
  EXPECT_EQ(light->text(), QStringLiteral("▲ Force at its limit: 3 updates"));
  EXPECT_EQ(light->property("role").toString(), QStringLiteral("warn"));
  EXPECT_EQ(timing->property("role").toString(), QStringLiteral("good")) << "of the timing alone";
  EXPECT_LT(light->minimumSizeHint().width(), 300) << "it leaves room in a narrow window";
}

TEST(ServoPanel, SaysThatThePositionLeapt) {
  ServoPanel panel;
  const auto* light = panel.findChild<QLabel*>(QStringLiteral("limit"));
  EXPECT_TRUE(light->isHidden());
  panel.begin(haptics::devices::punchKind(), 1000.0);
  for (const std::uint32_t leaps : {0U, 1U, 2U, 0U}) {
    auto sample = sampleAt(1, 5.0, 1.0);
    sample.leaps = leaps;
    panel.add(sample);
  }
  panel.refresh();
  EXPECT_EQ(light->text(), QStringLiteral("▲ Leaps of the position: 2, check the encoder's cable"));
}

TEST(CutTable, ShowsTheLandmarksThatAStrokeOfTheDeviceHas) {
  CutTable table;
  const auto shown = [&] {
    QStringList heads;
    for (int i = 0; i < table.columnCount(); ++i) {
      if (table.isColumnHidden(i)) continue;
      heads << table.horizontalHeaderItem(i)->text().replace(u'\n', u' ').trimmed();
      EXPECT_GE(table.columnWidth(i), table.horizontalHeader()->sectionSizeHint(i)) << "is cut off";
    }
    return heads.join(u' ').toStdString();
  };
  table.begin(haptics::devices::reamerKind(), 1000.0);
  EXPECT_EQ(shown(), "Depth Largest force Time");
  table.begin(haptics::devices::punchKind(), 1000.0);
  EXPECT_EQ(shown(), "N at N at N at N at Peak N");
  EXPECT_EQ(table.horizontalHeaderItem(0)->toolTip(), QStringLiteral("Interception: force [N]"));
  EXPECT_EQ(table.horizontalHeaderItem(3)->toolTip(), QStringLiteral("Yield: travel [units]"));
}

TEST(TravelPlot, DrawsEachStrokeAsACurveOfItsOwn) {
  TravelPlot plot;
  plot.begin(haptics::devices::punchKind());
  std::uint64_t tick = 0;
  const auto stroke = [&] {
    for (int i = 0; i <= 400; ++i) {
      const double share = i <= 200 ? i / 200.0 : (400 - i) / 200.0;
      plot.add(sampleAt(tick++, 13.0 * share, 5.0 * share));
    }
  };
  stroke();
  stroke();
  plot.refresh();
  const auto strokes = plot.strokes();
  ASSERT_EQ(strokes.size(), 3U) << "the third begins";
  double most = 0.0;
  for (const auto& point : strokes[1]) {
    EXPECT_NEAR(point.y(), 5.0 / 13.0 * point.x(), 1e-9);
    most = std::max(most, point.y());
  }
  EXPECT_NEAR(most, 5.0, 0.1);
  for (int i = 0; i < 10; ++i) stroke();
  EXPECT_EQ(plot.strokes().size(), static_cast<std::size_t>(TravelPlot::kStrokes));
}

TEST(LivePlot, ShowsAReamersTravelInMillimetres) {
  LivePlot plot;
  plot.begin(haptics::devices::reamerKind(), 1000.0);
  for (std::uint64_t tick = 0; tick < 40; ++tick) plot.add(sampleAt(tick, 0.012, 30.0));
  for (const auto& point : plot.channel(1)) EXPECT_DOUBLE_EQ(point.y(), 12.0);
  for (const auto& point : plot.channel(0)) EXPECT_DOUBLE_EQ(point.y(), 30.0);
  EXPECT_FALSE(plot.channel(1).empty());
}

TEST(LivePlot, PlotsTheTorqueOfAReamer) {
  LivePlot plot;
  plot.begin(haptics::devices::reamerKind(), 1000.0);
  for (std::uint64_t tick = 0; tick < 40; ++tick) {
    auto sample = sampleAt(tick, 0.012, 30.0);
    sample.torque = -0.75;
    plot.add(sample);
  }
  EXPECT_FALSE(plot.channel(2).empty());
  for (const auto& point : plot.channel(2)) EXPECT_DOUBLE_EQ(point.y(), -0.75);
}

TEST(CutTable, FillsARowForEachCut) {
  CutTable table;
  table.begin(haptics::devices::punchKind(), 1000.0);
  // Three strokes through tissue that is touched at 4 and cut at 8.
  for (std::uint64_t tick = 0; tick < 3000; ++tick) {
    const double phase = 2.0 * std::numbers::pi * static_cast<double>(tick) / 1000.0;
    const double travel = 5.5 - 5.5 * std::cos(phase);
    const bool isClosing = std::sin(phase) >= 0.0;
    const double force = isClosing && travel > 4.0 && travel < 8.0 ? 1.2 * (travel - 4.0) : 0.0;
    table.add(sampleAt(tick, travel, force));
  }
  ASSERT_EQ(table.rowCount(), 3);
  EXPECT_TRUE(table.item(0, 1)->text().startsWith(QStringLiteral("4.")))
      << table.item(0, 1)->text().toStdString();
  const double largest = table.item(1, 9)->text().split(u' ').front().toDouble();
  EXPECT_NEAR(largest, 4.8, 0.1);
  table.begin(haptics::devices::punchKind(), 1000.0);
  EXPECT_EQ(table.rowCount(), 0);
}

TEST(CutTable, IsNamedAfterTheDevicesStrokes) {
  CutTable table;
  table.begin(haptics::devices::punchKind(), 1000.0);
  EXPECT_EQ(table.accessibleName(), QStringLiteral("Cuts of this trial"));
  table.begin(haptics::devices::reamerKind(), 1000.0);
  EXPECT_EQ(table.accessibleName(), QStringLiteral("Strokes of this trial"));
}

TEST(TrialPage, CountsStrokesInEachDevicesWords) {
  for (const auto* kind : haptics::deviceKinds()) {
    for (const auto& language : words::languages()) {
      const TrialPage page(
          {.name = {}, .minimumCuts = 3, .device = kind, .language = language}, nullptr);
      const QString strokes = asText(kind->strokesName.in(language));
      const auto labels = page.findChildren<QLabel*>();
      EXPECT_TRUE(std::any_of(labels.begin(), labels.end(), [&](const QLabel* label) {
        return label->text() == QStringLiteral("0 of 3 ") + strokes;
      })) << strokes.toStdString();
    }
  }
}

}  // namespace live_trial_views_test
}  // namespace study::gui
