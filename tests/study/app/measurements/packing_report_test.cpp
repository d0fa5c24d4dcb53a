#include "study/app/measurements/packing_report.h"

#include <cmath>

#include <gtest/gtest.h>

#include "haptics/engine/built_in_models.h"
#include "study/app/measurements/feed_table.h"

namespace study::app {
namespace packing_report_test {

haptics::reaming::BoneFitReport fitWith(double gap, double error) {
  haptics::reaming::BoneFitReport report;
  report.curves.resize(1);
  report.curves[0].curve = "maximum";
  report.curves[0].fit.spheres.gap = gap;
  report.curves[0].fit.spheres.error = error;
  return report;
}

std::string warningOf(double gap, double error) {
  std::string all;
  for (const auto& warning : warningsOf(fitWith(gap, error))) all += warning;
  return all;
}

TEST(PackingReport, WarnsOfACurveThatWasNotFitted) {
  EXPECT_EQ(warningOf(0.005, 0.01), "");
  const auto missed = warningOf(1.0, 0.098);
  EXPECT_NE(missed.find("The maximum curve was not fitted"), std::string::npos) << missed;
  EXPECT_NE(missed.find("100 % above"), std::string::npos) << missed;
  EXPECT_NE(warningOf(std::nan(""), 0.0).find("was not fitted"), std::string::npos);
}

TEST(PackingReport, WarnsOfACurveThatTheSpheresCannotGive) {
  const auto missed = warningOf(1e-9, 0.3);
  EXPECT_NE(missed.find("cannot be felt with these spheres"), std::string::npos) << missed;
  EXPECT_NE(missed.find("30 %"), std::string::npos) << missed;
}

TEST(PackingReport, WarnsOfATorqueThatIsOff) {
  auto fit = fitWith(1e-9, 0.01);
  fit.curves[0].torqueError = 0.04;
  EXPECT_TRUE(warningsOf(fit).empty());
  fit.curves[0].torqueError = 0.44;
  const auto warnings = warningsOf(fit);
  ASSERT_EQ(warnings.size(), 1U);
  EXPECT_NE(warnings[0].find("torque of the maximum curve"), std::string::npos) << warnings[0];
  EXPECT_NE(warnings[0].find("44 %"), std::string::npos) << warnings[0];
}

/// The value of a column in a row.
double cellOf(const DataTable& table, std::size_t row, const std::string& column) {
  for (std::size_t i = 0; i < table.columns.size(); ++i) {
    if (table.columns[i].name == column) return std::get<double>(table.rows.at(row).at(i));
  }
  ADD_FAILURE() << "no column " << column;
  return 0.0;
}

TEST(FeedTable, GivesBackTheCurveAtTheMeasuredFeedsAndAccountsForAllMass) {
  const auto parametric = haptics::engine::parametricBone();
  haptics::reaming::PackedBone bone{.packing = parametric->packing};
  const auto fit = fitBoneToMaterial(bone, haptics::engine::parametricCurves(), {}, {.depths = 80});
  const auto table = feedTable(bone, fit);
  // 0.01, 0.03, 0.1, 0.3, 1 and 1.8 mm/s, for three curves.
  ASSERT_EQ(table.rows.size(), 18U);
  EXPECT_DOUBLE_EQ(cellOf(table, 0, "feed_mm_per_s"), 0.01);
  EXPECT_DOUBLE_EQ(cellOf(table, 1, "feed_mm_per_s"), 0.03);
  EXPECT_NEAR(cellOf(table, 5, "feed_mm_per_s"), 1.8, 1e-9);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    EXPECT_LT(cellOf(table, row, "unaccounted_share"), 1e-6) << row;
    EXPECT_GT(cellOf(table, row, "removed_share"), 0.01) << row;
  }
  for (const std::string depth : {"4", "6", "8"}) {
    for (std::size_t curve = 0; curve < 3; ++curve) {
      const std::size_t slow = 6 * curve;
      const double wanted = cellOf(table, slow, "curve_n_at_" + depth + "_mm");
      const auto forceIn = [&](std::size_t row) {
        return cellOf(table, row, "force_n_at_" + depth + "_mm");
      };
      // The bone's own ripple, and a slice of a sphere that is cut a step later.
      EXPECT_NEAR(forceIn(slow), wanted, 0.05 * wanted + 0.5) << depth << " " << curve;
      EXPECT_NEAR(forceIn(slow + 1), wanted, 0.05 * wanted + 0.5) << depth << " " << curve;
      // What the feed adds: 2000 N·s/m times 1.79 mm/s.
      EXPECT_NEAR(forceIn(slow + 5) - forceIn(slow), 3.58, 0.02 * wanted + 0.5)
          << depth << " " << curve;
    }
  }
}

TEST(FeedTable, OfAMaterialHasTheForceOfItsCurveAndWhatTheFeedAdds) {
  // F = 30 N/mm · z to 20 mm: removed to 10 mm are ½ · 30 kN/m · (10 mm)² = 1.5 N·m, a quarter.
  const haptics::reaming::CurveNodes ramp{{0.0, 0.0, 3e4}, {0.02, 600.0, 3e4}};
  const auto table = feedTable({ramp, ramp, ramp}, "average");
  ASSERT_EQ(table.rows.size(), 18U);
  for (std::size_t row = 0; row < table.rows.size(); ++row) {
    const double added = 2.0 * cellOf(table, row, "feed_mm_per_s");  // b = 2000 N·s/m
    for (const double depth : {4.0, 6.0, 8.0}) {
      const std::string place = std::to_string(static_cast<int>(depth));
      EXPECT_NEAR(cellOf(table, row, "curve_n_at_" + place + "_mm"), 30.0 * depth, 1e-9);
      EXPECT_NEAR(cellOf(table, row, "force_n_at_" + place + "_mm"), 30.0 * depth + added, 0.3)
          << row;
    }
    EXPECT_NEAR(cellOf(table, row, "removed_nm"), 1.5, 0.005) << row;
    EXPECT_NEAR(cellOf(table, row, "removed_share"), 0.25, 0.001) << row;
    EXPECT_LT(cellOf(table, row, "unaccounted_share"), 0.002) << row;
  }
}

}  // namespace packing_report_test
}  // namespace study::app
